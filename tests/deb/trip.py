#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""trip.py: trips the simulated ball of the running daemon by an open thermistor. Exit: 0 it has tripped, 1 it has not."""
import sys

from hedgehog import Ball

TIMEOUT_S = 60


def main():
    with Ball(timeout_s=TIMEOUT_S) as ball:
        events = ball.events(["state_changed"], timeout_s=TIMEOUT_S)
        ball.call("device.arm")
        ball.call("sim.set", fault={"faults": ["sensor_open"]})
        for event in events:
            if event["state"] == "tripped":
                print("tripped:", event["reason"])
                return 0
    return 1


if __name__ == "__main__":
    sys.exit(main())

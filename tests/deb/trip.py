#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""trip.py: trips the simulated ball of the running daemon by an open thermistor. Exit: 0 it has tripped, 1 not in five attempts."""
import sys

from hedgehog import Ball, RequestError

TIMEOUT_S = 60


def trip_reason(ball, events):
    """Of a ball that was armed; None when it could not be armed, or was lost before on a machine without time for it."""
    ball.call("sim.set", fault={"faults": []})
    try:
        ball.call("device.arm")
    except RequestError as refused:
        print(refused)
        return None
    ball.call("sim.set", fault={"faults": ["sensor_open"]})
    states = (event for event in events if event["state"] != "armed")
    event = next(states, {"state": "none"})
    return event["reason"] if event["state"] == "tripped" else None


def main():
    with Ball(timeout_s=TIMEOUT_S) as ball:
        events = ball.events(["state_changed"], timeout_s=TIMEOUT_S)
        for _ in range(5):
            reason = trip_reason(ball, events)
            if reason:
                print(f"tripped: {reason}")
                return 0
    return 1


sys.exit(main())

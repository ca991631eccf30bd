#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What is felt in a racing game: a lap of three seconds with two gear changes, a skid, a hit, a crate and a landing.

Exit: 0 it was played, 69 there is no daemon, or it has gone.
"""

import math
import sys
import time
from typing import List, Tuple

from hedgehog import Ball, Direction, NotConnected

# Eight steps from what is just felt to full strength are 32 % apart; people notice 13 % (thesis, experiment 2).
STEPS = 8
# Blows of these impulses are the first and the last step; Newton seconds.
SOFTEST_BLOW, HARDEST_BLOW = 150.0, 8000.0
# One blow in 0.25 s, unless a harder one comes.
APART_S = 0.25
# Of two effects only the one of higher priority is felt; of the same, both.
ENGINE, GEAR, SKID, BLOW = 3, 4, 5, 7
FRAMES, RATE_HZ = 180, 60
# Frame, what, where, and how hard; Newton seconds.
BLOWS: List[Tuple[int, str, Direction, float]] = [
    (100, "wall", [0.7, -0.7, 0.0], 5000.0), (105, "crate", "left", 300.0), (150, "landing", "down", 2500.0)]


def step_of(impulse_n_s: float) -> int:
    share = math.log(max(impulse_n_s, SOFTEST_BLOW) / SOFTEST_BLOW) / math.log(HARDEST_BLOW / SOFTEST_BLOW)
    return round((STEPS - 1) * min(share, 1.0))


class CarFeel:
    """Nothing here waits for a response."""

    def __init__(self, ball: Ball) -> None:
        self._ball = ball
        self._last_step = -1
        self._last_s = -APART_S

    def engine(self, revolutions: float, throttle: float) -> bool:
        """Every frame, 0..1 each. False: there is no daemon."""
        return self._ball.rumble("engine", 0.05 + 0.25 * throttle, "back", frequency_hz=30 + 60 * revolutions, priority=ENGINE)

    def skid(self, amount: float) -> None:
        """Every frame while the wheels slide; 0 they grip .. 1 not at all. It lasts, so it is weaker than a blow can be."""
        self._ball.rumble("skid", 0.5 * amount, "down", waveform="square", frequency_hz=60, priority=SKID)

    def gear(self) -> None:
        """The clutch has closed: a knock from behind."""
        self._pulse("back", 1, 40, GEAR)

    def impact(self, side: Direction, impulse_n_s: float, time_s: float) -> int:
        """The car was hit on that side, or landed; its step, or -1 when it is too soon to be felt."""
        step = step_of(impulse_n_s)
        if time_s - self._last_s < APART_S and step <= self._last_step:
            return -1
        self._last_step, self._last_s = step, time_s
        self._pulse(side, step, 180, BLOW)
        return step

    def _pulse(self, side: Direction, step: int, duration_ms: int, priority: int) -> None:
        limits = self._ball.hello["limits"]
        current_a = limits["felt_a"] * (limits["current_a"] / limits["felt_a"]) ** (step / (STEPS - 1))
        self._ball.notify("effect.pulse", direction=side, current_a=current_a, duration_ms=duration_ms, priority=priority)


def play_frame(feel: CarFeel, frame: int) -> bool:
    time_s = frame / RATE_HZ
    if frame in (30, 60):
        feel.gear()
        print("%.2f s  gear" % time_s)
    if 60 < frame < 90:
        feel.skid((frame - 60) / 30)
    for at, what, side, impulse_n_s in BLOWS:
        if frame == at:
            print("%.2f s  %s: step %d" % (time_s, what, feel.impact(side, impulse_n_s, time_s)))
    return feel.engine(frame % 60 / 60, 1.0)


def main() -> int:
    try:
        with Ball(name="racer example") as ball:
            feel = CarFeel(ball)
            for frame in range(FRAMES):
                if not play_frame(feel, frame):
                    raise NotConnected("the daemon has gone")
                time.sleep(1 / RATE_HZ)
            ball.stop_all()
    except NotConnected as nobody:
        print(nobody, file=sys.stderr)
        return 69
    return 0


if __name__ == "__main__":
    sys.exit(main())

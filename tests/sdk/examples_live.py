#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the racer's haptics in Python, JavaScript, C++ and C++ for Unreal with a simulated daemon: examples_live.py HEDGEHOGD PACKED
CPP UNREAL. PACKED: folder of pack.sh; CPP: program of examples/racer.cpp; UNREAL: program of unreal/live.cpp."""

import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXAMPLES = ROOT / "clients" / "examples"
sys.path.insert(0, str(ROOT / "clients" / "python"))

import hedgehog  # noqa: E402
from live_daemon import LIMIT_S, ForwardedAddress, LiveDaemon  # noqa: E402

UNREAL = sys.argv.pop(4) if len(sys.argv) > 4 else ""
CPP = sys.argv.pop(3) if len(sys.argv) > 3 else ""
PACKED = pathlib.Path(sys.argv.pop(2)) if len(sys.argv) > 2 else pathlib.Path()
DAEMON = sys.argv.pop(1) if len(sys.argv) > 1 else ""
# Steps 0 (just felt) to 7; -1: no pulse, because the crate follows the wall too soon.
LAP = ["0.50 s  gear", "1.00 s  gear", "1.67 s  wall: step 6", "1.75 s  crate: step -1", "2.50 s  landing: step 5"]
# Side, step, duration and priority; the crate is left out.
PULSES = [("back", 1, 40, 4), ("back", 1, 40, 4), ([0.7, -0.7, 0.0], 6, 180, 7), ("down", 5, 180, 7)]
SIDES = {"back": [-1.0, 0.0, 0.0], "down": [0.0, 0.0, -1.0]}
# By slot: side, waveform and priority of what lasts.
LASTING = {"engine": (SIDES["back"], None, 3), "skid": (SIDES["down"], "square", 5)}


def side_of(direction):
    return SIDES[direction] if isinstance(direction, str) else [float(one) for one in direction]


class Examples(unittest.TestCase):
    def check_lap(self, command, **environment):
        """The lap is printed as expected; engine and skid play in their slots, each impact and gear change as a pulse."""
        daemon = LiveDaemon(DAEMON)
        self.addCleanup(daemon.stop)
        address = ForwardedAddress()
        self.addCleanup(address.end)
        address.lead_to(daemon)
        with hedgehog.Ball(daemon.address, timeout_s=LIMIT_S) as watcher:
            events = watcher.events(["effect_started"], scope="all", timeout_s=LIMIT_S)
            printed = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, timeout=LIMIT_S,
                                     env=dict(os.environ, HEDGEHOG_ADDRESS=address.text, **environment)).stdout
            self.assertEqual([line for line in printed.splitlines() if " s  " in line], LAP)
            slots, pulses = set(), 0
            for event in events:
                slot = event.get("slot")
                pulses += slot is None
                slots.add(slot)
                if pulses == len(PULSES) and set(LASTING) <= slots:
                    break
            self.assertEqual(pulses, len(PULSES))
            self.assertEqual(slots, {None, *LASTING})
            self.check_requests(address.requests(), watcher.hello["limits"])

    def check_requests(self, requests, limits):
        """Every library plays the same: sides, strengths, durations, priorities."""
        felt_a, full_a = limits["felt_a"], limits["current_a"]
        played = [one["params"] for one in requests if one.get("method") == "effect.pulse"]
        self.assertEqual(len(played), len(PULSES))
        for pulse, (side, step, duration_ms, priority) in zip(played, PULSES):
            self.assertEqual((side_of(pulse["direction"]), pulse["duration_ms"], pulse["priority"]), (side_of(side), duration_ms, priority))
            self.assertAlmostEqual(pulse["current_a"], felt_a * (full_a / felt_a) ** (step / 7), delta=1e-3)
        lasting = [one["params"] for one in requests if one.get("method") == "effect.vibrate"]
        for slot, expected in LASTING.items():
            self.assertEqual([one for one in lasting if one["slot"] == slot and
                              (side_of(one["direction"]), one.get("waveform"), one.get("priority")) != expected], [])
        # 0.05 + 0.25, and half of what a skid without grip has, from the perception threshold up to full strength.
        for slot, strongest in (("engine", 0.3), ("skid", 0.5 * 29 / 30)):
            level = max(one["level"] for one in lasting if one["slot"] == slot)
            self.assertAlmostEqual(level, felt_a / full_a + strongest * (1 - felt_a / full_a), delta=1e-3)

    def test_python(self):
        self.check_lap([sys.executable, str(EXAMPLES / "racer.py")], PYTHONPATH=str(ROOT / "clients" / "python"))

    def test_javascript(self):
        with tempfile.TemporaryDirectory() as folder:
            library = pathlib.Path(folder) / "node_modules" / "@hedgehog"
            packed, = PACKED.glob("*.tgz")
            with tarfile.open(packed) as file:
                file.extractall(library)
            (library / "package").rename(library / "client")
            game = pathlib.Path(folder) / "racer.mjs"
            game.write_text((EXAMPLES / "racer.mjs").read_text(encoding="utf-8"), encoding="utf-8")
            self.check_lap(["node", str(game)])

    def test_cpp(self):
        self.check_lap([CPP])

    def test_unreal(self):
        self.check_lap([UNREAL, "racer"])

    def test_a_missing_daemon_is_reported_in_a_sentence(self):
        ended = subprocess.run([sys.executable, str(EXAMPLES / "racer.py")], stderr=subprocess.PIPE, text=True, check=False,
                               env=dict(os.environ, HEDGEHOG_ADDRESS="127.0.0.1:1", PYTHONPATH=str(ROOT / "clients" / "python")))
        self.assertEqual((ended.returncode, ended.stderr), (69, "the daemon does not run: 127.0.0.1:1: Connection refused\n"))


if __name__ == "__main__":
    unittest.main()

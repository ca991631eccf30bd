#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the Godot addon, its README and its example with a simulated daemon, in each available Godot: live.py HEDGEHOGD."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import project
from project import GODOT, HERE

sys.path[:0] = [str(HERE.parent), str(HERE.parent.parent.parent / "clients" / "python")]

import hedgehog  # noqa: E402
from live_daemon import LIMIT_S, ForwardedAddress, LiveDaemon, Tunnel, limit  # noqa: E402

DAEMON = sys.argv.pop(1) if len(sys.argv) > 1 else ""
FORMS = {
    "godot3": ((r"ANSWER\((.*)\)$", r'yield(\1, "completed")'),
               (r"CONNECT\((\w+), (\w+)\)", r'ball.connect("\1", self, "\2")')),
    "godot4": ((r"ANSWER\((.*)\)$", r"await \1.completed"), (r"CONNECT\((\w+), (\w+)\)", r"ball.\1.connect(\2)")),
}


class Live(unittest.TestCase):
    def setUp(self):
        self.daemon = None
        self.games = []

    def tearDown(self):
        for game in self.games:
            game.kill()
            game.wait()
            game.stdout.close()
        if self.daemon:
            self.daemon.stop()

    def start_daemon(self):
        self.daemon = LiveDaemon(DAEMON)
        return self.daemon

    def start(self, engine, main, others=(), **environment):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        project.make_project(folder.name, engine, main, others)
        self.games.append(project.start(folder.name, engine, dict(os.environ, **environment)))
        self.addCleanup(limit(self.games[-1]).cancel)
        return self.games[-1]

    def scene(self, engine, name, address, **environment):
        text = (HERE / "live.gd").read_text(encoding="utf-8")
        for form, written in FORMS[engine]:
            text = re.sub(form, written, text, flags=re.M)
        return self.start(engine, text, HEDGEHOG_SCENE=name, HEDGEHOG_ADDRESS=address, **environment)

    def wait_for(self, game, text):
        """Reads lines until one contains `text`; returns them."""
        lines = []
        for line in game.stdout:
            lines.append(line.rstrip("\n"))
            self.assertNotIn("SCRIPT ERROR", line)
            if text in line:
                return lines
        self.fail("%r was not printed: %s" % (text, "\n".join(lines)))

    def each_engine(self):
        self.assertTrue(project.engines(), "there is no godot3-server")
        return list(project.engines())

    def started(self, watcher, count):
        """The slots of the effects that started, once there are `count` of them."""
        slots = []
        for event in watcher:
            slots.append(event.get("slot"))
            if len(set(slots)) >= count:
                return set(slots)

    def test_the_first_example_of_the_readme_runs_in_an_empty_project(self):
        self.start_daemon()
        text = (GODOT / "README.md").read_text(encoding="utf-8")
        example = re.search(r"```gdscript\n(.*?)```", text, re.S).group(1)
        self.assertLessEqual(len(example.splitlines()), 10)
        for engine in self.each_engine():
            with hedgehog.Ball(self.daemon.address, timeout_s=60) as watcher:
                events = watcher.events(["effect_started"], scope="all", timeout_s=60)
                self.start(engine, example, HEDGEHOG_ADDRESS=self.daemon.address)
                self.assertEqual(self.started(events, 2), {None, "engine"})

    def test_the_example_drives_its_lap(self):
        self.start_daemon()
        for engine in self.each_engine():
            with hedgehog.Ball(self.daemon.address, timeout_s=60) as watcher:
                events = watcher.events(["effect_started"], scope="all", timeout_s=60)
                game = self.start(engine, (GODOT / "example" / "main.gd").read_text(encoding="utf-8"),
                                  [GODOT / "example" / "car_feel.gd"], HEDGEHOG_ADDRESS=self.daemon.address)
                self.assertEqual(self.started(events, 3), {None, "engine", "skid"})
                lines = game.communicate(timeout=LIMIT_S)[0].splitlines()
                self.assertEqual(game.returncode, 0)
                self.assertEqual([line for line in lines if " at " in line and line.endswith(" s")],
                                 ["hit at 3 s", "landing at 4 s"])
                self.assertNotIn("SCRIPT ERROR", "\n".join(lines))

    def test_effects_events_telemetry_and_refusals(self):
        self.start_daemon()
        for engine in self.each_engine():
            lines = self.wait_for(self.scene(engine, "effects", self.daemon.address), "telemetry ")
            for expected in ("state armed", "fields True", "same pin True", "stopped 1", "refused refused invalid_params level", "its code True",
                             "infinite keyframes[0].level: is no number", "event effect_ended completed",
                             "telemetry with limit_a True"):
                self.assertIn(expected, lines)
            warnings = "\n".join(lines)
            for expected in ("effect.pulse: there is no parameter 'strenght'", "effect.pulse: level: is above 1",
                             "effect.pulse: waveform: is none of [constant"):
                self.assertIn(expected, warnings)

    def test_a_restarted_daemon_is_reconnected_with_its_events(self):
        address = ForwardedAddress()
        self.addCleanup(address.end)
        for engine in self.each_engine():
            address.lead_to(self.start_daemon())
            game = self.scene(engine, "outage", address.text)
            self.wait_for(game, "event effect_ended completed")
            self.daemon.stop()
            self.wait_for(game, "disconnected the connection to the daemon has ended: the daemon closed it")
            address.lead_to(self.start_daemon())
            self.wait_for(game, "event effect_ended completed")
            self.daemon.stop()
        self.daemon = None

    def test_a_ball_behind_tls_is_played_through_a_tunnel(self):
        daemon = self.start_daemon()
        for engine in self.each_engine():
            tunnel = Tunnel(DAEMON, daemon)
            try:
                lines = self.wait_for(self.scene(engine, "effects", tunnel.address), "telemetry ")
                for expected in ("connected play", "state armed", "stopped 1", "refused refused invalid_params level",
                                 "event effect_ended completed", "telemetry with limit_a True"):
                    self.assertIn(expected, lines)
                game = self.scene(engine, "outage", tunnel.address)
                self.wait_for(game, "event effect_ended completed")
                tunnel.stop()
                self.wait_for(game, "disconnected the connection to the daemon has ended: ")
                tunnel = Tunnel(DAEMON, daemon, tunnel.port)
                self.wait_for(game, "event effect_ended completed")
            finally:
                tunnel.stop()

    def test_no_frame_waits_for_a_name_server(self):
        _, _, port = self.start_daemon().address.partition(":")
        for engine in self.each_engine():
            with tempfile.TemporaryDirectory() as folder:
                known = pathlib.Path(folder) / "known"
                game = self.scene(engine, "slow_name", "slow.test:" + port, HEDGEHOG_NAMES_KNOWN=str(known),
                                  LD_PRELOAD=os.environ["HEDGEHOG_SLOW_NAMES"])
                self.wait_for(game, "30 frames, connected False")
                known.touch()
                self.wait_for(game, "connected ")

    def test_a_missing_daemon_is_reported_in_a_sentence(self):
        for engine in self.each_engine():
            lines = self.wait_for(self.scene(engine, "missing_daemon", "127.0.0.1:1"), "this ball is closed")
            self.assertIn("not_connected the daemon does not run: 127.0.0.1:1: the connection failed", lines)
            self.assertTrue(any(line.startswith("again not_connected the daemon does not run") for line in lines))

    def test_a_name_without_address_is_reported_in_a_sentence(self):
        for engine in self.each_engine():
            game = self.scene(engine, "missing_daemon", "unknown.test", LD_PRELOAD=os.environ["HEDGEHOG_SLOW_NAMES"])
            self.assertIn("not_connected the daemon does not run: unknown.test:7586: its name has no address",
                          self.wait_for(game, "this ball is closed"))

    def test_addresses_are_read_as_every_client_reads_them(self):
        for engine in self.each_engine():
            lines = self.wait_for(self.scene(engine, "addresses", ""), "mdns://ball-7")
            for expected in ("game-pc game-pc:7586", "::1 [::1]:7586", "[::1]:9 [::1]:9", "tcp:127.0.0.1:7 127.0.0.1:7"):
                self.assertIn(expected, lines)
            refused = [line for line in lines if "is no address of a daemon" in line]
            self.assertEqual([line.split(" ")[0] for line in refused],
                             ["host:x", "host:0", "[::1", "unix:", ":7", "host:70000", "host:", "/run/x", "tls://ball-host", "mdns://ball-7"])
            self.assertIn("/run/x '/run/x' is no address of a daemon: Godot has no Unix sockets", refused[-3])
            for address, line in zip(("tls://ball-host", "mdns://ball-7"), refused[-2:]):
                self.assertIn("; hedgehogctl tunnel %s " % address, line)


class Generated(unittest.TestCase):
    def test_methods_and_fields_are_those_of_the_openrpc_document(self):
        subprocess.run([sys.executable, str(pathlib.Path(GODOT) / "generate.py"), "--check"], check=True)


if __name__ == "__main__":
    unittest.main()

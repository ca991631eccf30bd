#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the Unreal plugin and its README with a simulated daemon: live.py HEDGEHOGD PROGRAM, the program of live.cpp."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent.parent
sys.path[:0] = [str(ROOT / "tests" / "sdk"), str(ROOT / "clients" / "python")]

import hedgehog  # noqa: E402
import quick_start  # noqa: E402
import readme  # noqa: E402
from live_daemon import ForwardedAddress, LiveDaemon, Tunnel, limit  # noqa: E402

PROGRAM = sys.argv.pop(2) if len(sys.argv) > 2 else ""
DAEMON = sys.argv.pop(1) if len(sys.argv) > 1 else ""


class Live(unittest.TestCase):
    def start_daemon(self):
        daemon = LiveDaemon(DAEMON)
        self.addCleanup(daemon.stop)
        return daemon

    def start(self, scene, address, **environment):
        game = subprocess.Popen([PROGRAM, scene], env=dict(os.environ, HEDGEHOG_ADDRESS=address, **environment),
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(self.stop, game)
        self.addCleanup(limit(game).cancel)
        return game

    @staticmethod
    def stop(process):
        if process.poll() is None:
            process.terminate()
        process.wait()
        process.stdout.close()

    def wait_for(self, game, text):
        lines = []
        for line in game.stdout:
            lines.append(line.rstrip("\n"))
            if line.startswith(text):
                return lines
        self.fail("%r was not printed: %s" % (text, "\n".join(lines)))

    def slots_of_the_quick_start(self, count, members=""):
        """The slots of its first effects, when so many have been played; None: an effect without a slot."""
        guide = readme.Readme("unreal/README.md")
        address = self.start_daemon().address
        slots = set()
        with tempfile.TemporaryDirectory() as folder, hedgehog.Ball(address, timeout_s=60) as watcher:
            project = guide.project(folder, "cpp", quick_start.FILES)
            quick_start.add_members(project, members)
            for command in guide.commands()[1:]:
                subprocess.run(["bash", "-c", command], cwd=project, check=True)
            events = watcher.events(["effect_started"], scope="all", timeout_s=60)
            running = quick_start.start(project, dict(os.environ, HEDGEHOG_ADDRESS=address))
            self.addCleanup(self.stop, running)
            self.addCleanup(limit(running).cancel)
            for event in events:
                slots.add(event.get("slot"))
                if len(slots) == count:
                    break
        return slots

    def test_the_quick_start_of_the_readme_is_felt(self):
        program = readme.Readme("unreal/README.md").program("cpp")
        self.assertLessEqual(len(program.splitlines()), 10)
        self.assertEqual(self.slots_of_the_quick_start(1), {None})

    def test_the_members_that_the_readme_adds_rumble_in_each_frame(self):
        members = readme.Readme("unreal/README.md").program("cpp", 1)
        self.assertEqual(self.slots_of_the_quick_start(2, members), {None, "engine"})

    def test_effects_events_status_and_refusals(self):
        address = self.start_daemon().address
        lines = self.wait_for(self.start("effects", address), "over")
        self.assertIn("connected", lines)
        self.assertIn("event effect_ended  completed", lines)
        self.assertIn("flowed", lines)
        playing = next(line for line in lines if line.startswith("playing "))
        for expected in ('"state":"armed"', '"slot":"Größe"', '"method":"effect.circle"', '"method":"effect.play"'):
            self.assertIn(expected, playing)
        self.assertIn("refused effect.pulse invalid_params level InvalidParams", lines)
        self.assertIn("no object: the parameters are no JSON object", lines)
        self.assertIn("measured", lines)

    def test_a_restarted_daemon_is_reconnected_with_its_events(self):
        address = ForwardedAddress()
        self.addCleanup(address.end)
        daemon = self.start_daemon()
        address.lead_to(daemon)
        game = self.start("outage", address.text)
        self.wait_for(game, "event effect_ended")
        daemon.stop()
        self.wait_for(game, "disconnected the connection to the daemon has ended: ")
        address.lead_to(self.start_daemon())
        self.wait_for(game, "event effect_ended")

    def test_a_ball_behind_tls_is_played_through_a_tunnel(self):
        daemon = self.start_daemon()
        tunnel = Tunnel(DAEMON, daemon)
        try:
            lines = self.wait_for(self.start("effects", tunnel.address), "over")
            for expected in ("connected", "event effect_ended  completed", "refused effect.pulse invalid_params level InvalidParams",
                             "measured"):
                self.assertIn(expected, lines)
            game = self.start("outage", tunnel.address)
            self.wait_for(game, "event effect_ended")
            tunnel.stop()
            self.wait_for(game, "disconnected the connection to the daemon has ended: ")
            tunnel = Tunnel(DAEMON, daemon, tunnel.port)
            self.wait_for(game, "event effect_ended")
        finally:
            tunnel.stop()

    def test_no_frame_waits_for_a_name_server(self):
        _, _, port = self.start_daemon().address.partition(":")
        with tempfile.TemporaryDirectory() as folder:
            known = pathlib.Path(folder) / "known"
            game = self.start("slow_name", "slow.test:" + port, HEDGEHOG_NAMES_KNOWN=str(known),
                              LD_PRELOAD=os.environ["HEDGEHOG_SLOW_NAMES"])
            self.wait_for(game, "30 frames, not connected")
            known.touch()
            self.assertIn("connected", self.wait_for(game, "over"))

    def test_each_address_of_a_name_is_tried(self):
        _, _, port = self.start_daemon().address.partition(":")
        game = self.start("slow_name", "several.test:" + port, LD_PRELOAD=os.environ["HEDGEHOG_SLOW_NAMES"])
        self.assertIn("connected", self.wait_for(game, "over"))

    def test_a_name_without_address_is_reported_in_a_sentence(self):
        game = self.start("missing_daemon", "unknown.test", LD_PRELOAD=os.environ["HEDGEHOG_SLOW_NAMES"])
        self.assertIn("the daemon does not run: unknown.test:7586: no daemon answers there", self.wait_for(game, "over"))

    def test_a_missing_daemon_is_reported_in_a_sentence(self):
        lines = self.wait_for(self.start("missing_daemon", "127.0.0.1:1"), "over")
        self.assertIn("the daemon does not run: 127.0.0.1:1: no daemon answers there", lines)

    def test_an_invalid_address_is_reported_in_a_sentence(self):
        for address in ("host:x", "host:0", "[::1", "unix:", ":7", "host:70000", "host:", "/run/x"):
            lines = self.wait_for(self.start("missing_daemon", address), "over")
            self.assertTrue(any(line.startswith("'%s' is no address of a daemon: " % address) for line in lines), lines)
        for address in ("tls://ball-host", "mdns://ball-7"):
            lines = self.wait_for(self.start("missing_daemon", address), "over")
            self.assertTrue(any("; hedgehogctl tunnel %s " % address in line for line in lines), lines)


class Generated(unittest.TestCase):
    def test_effects_events_status_and_methods_are_those_of_the_openrpc_document(self):
        subprocess.run([sys.executable, str(ROOT / "clients" / "unreal" / "generate.py"), "--check"], check=True)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the Python library and its README with a simulated daemon: python_live.py HEDGEHOGD."""

import asyncio
import inspect
import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import threading
import unittest
from unittest import mock

from mdns_responder import Responder

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PYTHON = ROOT / "clients" / "python"
sys.path.insert(0, str(PYTHON))

import hedgehog  # noqa: E402
import live_daemon  # noqa: E402
from hedgehog.methods import AsyncMethods, Methods  # noqa: E402

DAEMON = sys.argv.pop(1) if len(sys.argv) > 1 else ""


class Live(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.daemon = live_daemon.LiveDaemon(DAEMON)
        cls.address = cls.daemon.address

    @classmethod
    def tearDownClass(cls):
        cls.daemon.stop()

    def test_the_first_example_of_the_readme_runs_in_an_empty_folder(self):
        text = (PYTHON / "README.md").read_text(encoding="utf-8")
        example = re.search(r"```python\n(.*?)```", text, re.S).group(1)
        self.assertLessEqual(len(example.splitlines()), 10)
        with tempfile.TemporaryDirectory() as empty:
            printed = subprocess.run([sys.executable, "-c", example], cwd=empty, check=True, text=True,
                                     stdout=subprocess.PIPE, timeout=live_daemon.LIMIT_S,
                                     env=dict(os.environ, PYTHONPATH=str(PYTHON), HEDGEHOG_ADDRESS=self.address)).stdout
        self.assertGreater(float(printed), 10.0)

    def test_the_shortest_program_pushes(self):
        program = 'from hedgehog import Ball\nwith Ball() as ball: ball.pulse("left", level=0.5); print(ball.status()["temperature_c"])'
        with hedgehog.Ball(self.address, timeout_s=60) as watcher:
            events = watcher.events(["effect_started", "effect_ended"], scope="all", timeout_s=60)
            printed = subprocess.run([sys.executable, "-c", program], check=True, text=True, stdout=subprocess.PIPE,
                                     timeout=live_daemon.LIMIT_S,
                                     env=dict(os.environ, PYTHONPATH=str(PYTHON), HEDGEHOG_ADDRESS=self.address)).stdout
            # An effect of another test may end first: a daemon stops a client's effects after the client has left.
            started = next(event for event in events if event["type"] == "effect_started")
            ended = next(event for event in events if event["type"] == "effect_ended" and event["effect"] == started["effect"])
        self.assertIn("'coils': [", printed)
        self.assertIn(ended["reason"], ("disconnected", "completed"), "on a slow machine it may live longer than its pulse")

    def test_a_pulse_is_played_and_ends(self):
        with hedgehog.Ball(self.address, timeout_s=60) as ball:
            events = ball.events(["effect_ended"], timeout_s=60)
            effect = ball.pulse("left", level=0.5, duration_ms=30)["effect"]
            ended = next(events)
            self.assertEqual((ended["effect"], ended["reason"]), (effect, "completed"))

    def test_a_remote_daemon_is_verified_by_its_fingerprint_and_gets_the_token(self):
        known = dict(token=self.daemon.token, fingerprint=self.daemon.fingerprint, timeout_s=60)
        with hedgehog.Ball(self.daemon.tls_address, **known) as ball:
            self.assertEqual(ball.hello["role"], "play")
            self.assertTrue(ball.rumble("engine", 0.3, "back"))
            events = ball.events(["effect_ended"], timeout_s=60)
            effect = ball.pulse("left", level=0.5, duration_ms=30)["effect"]
            self.assertIn(effect, (event["effect"] for event in events))

        async def play():
            async with hedgehog.AsyncBall(self.daemon.tls_address, **known) as ball:
                return (await ball.pulse("left"))["accepted"]

        self.assertTrue(asyncio.run(play()))

    def test_an_announced_daemon_is_verified_by_its_fingerprint_too(self):
        host, _, port = self.daemon.tls_address.removeprefix("tls://").partition(":")
        responder = Responder([("ball-7", "0007", host, int(port))])
        self.addCleanup(responder.close)
        with mock.patch.dict(os.environ, {"HEDGEHOG_MDNS_PORT": str(responder.port)}):
            known = dict(token=self.daemon.token, fingerprint=self.daemon.fingerprint, timeout_s=60)
            with hedgehog.Ball("mdns://ball-7", **known) as ball:
                self.assertEqual(ball.hello["role"], "play")

            async def role():
                async with hedgehog.AsyncBall("mdns://0007", **known) as ball:
                    return ball.hello["role"]

            self.assertEqual(asyncio.run(role()), "play")
            with self.assertRaisesRegex(hedgehog.NotConnected, "another fingerprint"):
                hedgehog.Ball("mdns://ball-7", token=self.daemon.token, fingerprint="0" * 64, timeout_s=60)

    def test_another_fingerprint_or_authority_is_rejected(self):
        for fingerprint, why in (("0" * 64, "another fingerprint"), (None, "certificate")):
            with self.assertRaisesRegex(hedgehog.NotConnected, why):
                hedgehog.Ball(self.daemon.tls_address, token=self.daemon.token, fingerprint=fingerprint, timeout_s=60)
        with self.assertRaises(hedgehog.AddressError):
            hedgehog.Ball(self.daemon.tls_address, fingerprint="0")
        with self.assertRaisesRegex(hedgehog.RequestError, "token"):
            hedgehog.Ball(self.daemon.tls_address, token="hht_wrong", fingerprint=self.daemon.fingerprint, timeout_s=60)

    def test_a_rumble_continues_in_its_slot_and_ends(self):
        with hedgehog.Ball(self.address, timeout_s=60) as ball:
            events = ball.events(["effect_started"], timeout_s=60)
            self.assertTrue(ball.rumble("engine", 0.3, "back", lease_ms=10_000))
            self.assertEqual(next(events)["slot"], "engine")
            self.assertTrue(ball.rumble("engine", 0.4, "back", lease_ms=10_000))
            self.assertEqual([e["slot"] for e in ball.status()["effects"]], ["engine"])
            ball.rumble("engine", 0)
            self.assertEqual(ball.stop_all()["stopped"], 0)

    def test_a_thread_that_waits_for_events_blocks_no_call_of_another(self):
        with hedgehog.Ball(self.address, timeout_s=60) as ball:
            events = ball.events(["effect_ended"])
            received = []
            waiting = threading.Thread(target=lambda: received.append(next(events)))
            waiting.start()
            effect = ball.pulse("left", duration_ms=30)["effect"]
            waiting.join(60)
            self.assertEqual([event["effect"] for event in received], [effect])

    def test_concurrent_calls_of_several_tasks(self):
        async def ask():
            async with hedgehog.AsyncBall(self.address, timeout_s=60) as ball:
                answers = await asyncio.gather(ball.ping(), ball.status(), ball.describe())
                statuses = []
                async for status in ball.telemetry(100, ["limit_a"]):
                    statuses.append(status)
                    if len(statuses) == 3:
                        return answers, statuses
        answers, statuses = asyncio.run(ask())
        self.assertEqual(answers[1]["state"], "armed")
        self.assertTrue(all("limit_a" in status for status in statuses))

    def test_telemetry_does_not_prolong_the_wait_for_an_event(self):
        clock = [1000.0]

        with hedgehog.Ball(self.address, timeout_s=60) as ball:
            def receive(_):
                clock[0] += 0.05
                self.assertLess(clock[0], 1010.0, "the wait has begun anew with each message")
                ball._exchange.receive(b'{"jsonrpc":"2.0","method":"telemetry","params":{"limit_a":5}}\n')
                return True

            events = ball.events(["effect_ended"], timeout_s=0.2)
            with mock.patch.object(ball, "_receive", receive), mock.patch("time.monotonic", lambda: clock[0]):
                self.assertEqual(list(events), [])
            self.assertEqual(ball.next_notification(), ("telemetry", {"limit_a": 5}))

    def test_a_strength_that_is_no_number_ends_a_rumble(self):
        with hedgehog.Ball(self.address, timeout_s=60) as ball, mock.patch.object(ball, "notify") as sent:
            ball.rumble("engine", float("nan"), "back")
            sent.assert_called_once_with("effect.stop", slot="engine")

        async def rumble():
            async with hedgehog.AsyncBall(self.address, timeout_s=60) as ball:
                with mock.patch.object(ball, "notify", mock.AsyncMock()) as sent:
                    await ball.rumble("engine", float("nan"), "back")
                    sent.assert_called_once_with("effect.stop", slot="engine")
        asyncio.run(rumble())

    def test_a_missing_daemon_is_reported_in_a_sentence(self):
        with self.assertRaisesRegex(hedgehog.NotConnected, r"the daemon does not run: 127\.0\.0\.1:1: Connection refused"):
            hedgehog.Ball("127.0.0.1:1")


class Silent:
    """A daemon that accepts every connection, perhaps, and answers nothing: what is waited for takes its whole timeout, of a clock
    of its own."""

    def __init__(self, accepts):
        self.now_s = 1000.0
        self.accepts = accepts
        self.connected_s = None

    def monotonic(self):
        return self.now_s

    def open(self, address, timeout_s):
        self.now_s += timeout_s
        if address != self.accepts:
            raise OSError("no answer")
        self.connected_s = self.now_s
        silent = self
        fake = mock.Mock()
        fake.settimeout = lambda given_s: setattr(silent, "timeout_s", given_s)

        def recv(_):
            silent.now_s += silent.timeout_s
            raise socket.timeout
        fake.recv = recv
        return fake


class Deadlines(unittest.TestCase):
    def seconds(self, accepts):
        silent = Silent(accepts)
        with mock.patch("hedgehog.ball.open_socket", silent.open), mock.patch("time.monotonic", silent.monotonic), \
                mock.patch.dict(os.environ, {"RUNTIME_DIRECTORY": "/a", "HEDGEHOG_ADDRESS": ""}), \
                self.assertRaises(hedgehog.NotConnected):
            hedgehog.Ball(timeout_s=2.0)
        return silent.now_s - 1000.0, silent.connected_s

    def test_connecting_takes_no_longer_than_its_timeout_altogether(self):
        for accepts in (None, ("127.0.0.1", 7586), "/a/hedgehogd.sock"):
            self.assertAlmostEqual(self.seconds(accepts)[0], 2.0, delta=0.01)

    def test_an_address_that_does_not_answer_leaves_time_to_the_next(self):
        self.assertIsNotNone(self.seconds(("127.0.0.1", 7586))[1])

    def test_a_host_with_several_addresses_has_one_timeout(self):
        found = [(socket.AF_INET, socket.SOCK_STREAM, 0, "", ("127.0.0.1", 1))] * 4
        timeouts = []
        silent = Silent(None)

        def connect(one, _):
            timeouts.append(one.gettimeout())
            silent.now_s += one.gettimeout()
            raise socket.timeout("timed out")
        with mock.patch("socket.getaddrinfo", return_value=found), mock.patch("time.monotonic", silent.monotonic), \
                mock.patch.object(hedgehog.sockets.socket.socket, "connect", connect), self.assertRaises(socket.timeout):
            hedgehog.sockets.open_socket(("slow.test", 7586), 2.0)
        self.assertEqual([round(one_s, 3) for one_s in timeouts], [0.5, 0.5, 0.5, 0.5])

    def test_without_unix_sockets_the_next_address_is_tried(self):
        """As on Windows, whose asyncio has no such function."""
        async def why():
            ball = hedgehog.AsyncBall()
            with self.assertRaises(hedgehog.NotConnected) as raised:
                await ball.ping()
            return str(raised.exception)
        with mock.patch.dict(os.environ, {"RUNTIME_DIRECTORY": "/a", "HEDGEHOG_ADDRESS": ""}), \
                mock.patch("asyncio.open_connection", side_effect=OSError("nobody")), \
                mock.patch("asyncio.open_unix_connection") as function:
            del asyncio.open_unix_connection
            try:
                text = asyncio.run(why())
            finally:
                asyncio.open_unix_connection = function
        self.assertIn("/a/hedgehogd.sock: this system has no Unix sockets; ", text)
        self.assertIn("127.0.0.1:7586: nobody", text)


class Generated(unittest.TestCase):
    def test_methods_are_those_of_the_openrpc_document(self):
        subprocess.run([sys.executable, str(PYTHON / "generate.py"), "--check"], check=True)

    def test_every_parameter_has_its_name(self):
        document = json.loads((ROOT / "protocol/schema/openrpc.json").read_text(encoding="utf-8"))
        for method in document["methods"]:
            if not method["name"].startswith("effect."):
                continue
            for cls in (Methods, AsyncMethods):
                function = getattr(cls, method["name"].split(".")[1])
                self.assertEqual({p["name"] for p in method["params"]},
                                 set(inspect.signature(function).parameters) - {"self"})


class Addresses(unittest.TestCase):
    def test_are_those_of_every_client(self):
        self.assertEqual(hedgehog.address.daemon_addresses(None, {"HEDGEHOG_ADDRESS": "[::1]:9"}), [("::1", 9)])
        self.assertEqual(hedgehog.address.daemon_addresses(None, {"RUNTIME_DIRECTORY": "/a:/b", "XDG_RUNTIME_DIR": "/u"}),
                         ["/a/hedgehogd.sock", "/run/hedgehog/hedgehogd.sock", "/u/hedgehog/hedgehogd.sock",
                          ("127.0.0.1", 7586)])
        self.assertEqual(hedgehog.address.daemon_addresses(None, {}),
                         ["/run/hedgehog/hedgehogd.sock", "/tmp/hedgehog-%d/hedgehogd.sock" % os.getuid(),
                          ("127.0.0.1", 7586)])
        self.assertEqual(hedgehog.address.parse_address("game-pc"), ("game-pc", 7586))
        self.assertEqual(hedgehog.address.parse_address("::1"), ("::1", 7586))

    def test_invalid_ones_are_refused(self):
        for text in ("host:x", "host:0", "[::1", "unix:", ":7", "host:70000", "host:"):
            with self.assertRaisesRegex(hedgehog.AddressError, "is no address of a daemon"):
                hedgehog.address.parse_address(text)

    def test_a_host_name_that_cannot_be_looked_up_is_reported_in_a_sentence(self):
        """getaddrinfo raises UnicodeError for it."""
        async def ping():
            await hedgehog.AsyncBall().ping()
        for name in ("a..b", "x" * 64):
            with mock.patch.dict(os.environ, {"HEDGEHOG_ADDRESS": name}):
                for connect in (hedgehog.Ball, lambda: asyncio.run(ping())):
                    with self.assertRaisesRegex(hedgehog.NotConnected, "the daemon does not run: %s:7586: .*label" % re.escape(name)):
                        connect()


if __name__ == "__main__":
    unittest.main()

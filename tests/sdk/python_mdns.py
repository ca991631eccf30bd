#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs mdns.json on the Python library, and searches on the loopback interface."""

import asyncio
import json
import os
import pathlib
import sys
import unittest
from unittest import mock

from mdns_responder import Responder

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "clients" / "python"))

import hedgehog  # noqa: E402
from hedgehog import address, discovery, mdns  # noqa: E402

VECTORS = json.loads((HERE / "mdns.json").read_text(encoding="utf-8"))
FINGERPRINT = "a" * 64


def balls_of(one):
    return [mdns.DiscoveredBall(**ball) for ball in one["balls"]]


class Vectors(unittest.TestCase):
    def test_searches(self):
        for one in VECTORS["searches"]:
            with self.subTest(one["name"]):
                answers = mdns.Answers(VECTORS["id"])
                for packet in one["packets"]:
                    answers.read(bytes.fromhex(packet))
                self.assertEqual(answers.balls(), balls_of(one))
                if "query" in one:
                    self.assertEqual(answers.query().hex(), one["query"])

    def test_every_cut_and_every_flipped_byte_ends(self):
        for one in VECTORS["searches"][:3]:
            for packet in map(bytes.fromhex, one["packets"]):
                for at in range(len(packet)):
                    answers = mdns.Answers(VECTORS["id"])
                    answers.read(packet[:at])
                    self.assertEqual(answers.balls(), [])
                    answers.read(packet[:at] + bytes((packet[at] ^ 0xFF,)) + packet[at + 1:])
                    answers.balls()
                    answers.query()

    def test_a_flood_is_bounded(self):
        answers = mdns.Answers(VECTORS["id"])
        for number in range(2000):
            instance = b"\x04%04d" % number + mdns.SERVICE
            answers.read(bytes.fromhex("123484000000000100000000") + mdns.SERVICE + bytes.fromhex("000c00010000000a")
                         + len(instance).to_bytes(2, "big") + instance)
        self.assertEqual(len(answers._instances), 256)
        self.assertLessEqual(len(answers.query()), 1200)

    def test_choices(self):
        for one in VECTORS["choices"]:
            with self.subTest(one["name"]):
                if "error" in one:
                    with self.assertRaises(discovery.BallNotFound) as raised:
                        discovery.chosen(one["asked"], balls_of(one))
                    self.assertEqual(str(raised.exception), one["error"])
                else:
                    chosen = discovery.chosen(one["asked"], balls_of(one))
                    self.assertEqual([address.describe(address.TlsAddress(ball.address, ball.port, b"")) for ball in chosen],
                                     one["addresses"])

    def test_addresses(self):
        for one in VECTORS["addresses"]:
            with self.subTest(one["text"]):
                environment = {"HEDGEHOG_ADDRESS": one["text"], "HEDGEHOG_FINGERPRINT": one["fingerprint"]}
                if "error" in one:
                    with self.assertRaises(hedgehog.AddressError) as raised:
                        address.daemon_addresses(environment=environment)
                    self.assertEqual(str(raised.exception), one["error"])
                else:
                    (meant,) = address.daemon_addresses(environment=environment)
                    self.assertEqual((address.describe(meant), meant.fingerprint.hex()), (one["means"], one["fingerprint"]))


class OnLoopback(unittest.TestCase):
    def announce(self, *balls):
        responder = Responder(balls)
        self.addCleanup(responder.close)
        environment = mock.patch.dict(os.environ, {"HEDGEHOG_MDNS_PORT": str(responder.port)})
        environment.start()
        self.addCleanup(environment.stop)
        return responder

    def test_all_balls_are_listed(self):
        self.announce(("ball-7", "0007", "127.0.0.1", 17586), ("ball-9", "0009", "127.0.0.1", 17587))
        found = hedgehog.discover(2.0)
        self.assertEqual(found, [
            mdns.DiscoveredBall("ball-7", "lab.local", "127.0.0.1", 17586, "0007", "1.0", True),
            mdns.DiscoveredBall("ball-9", "lab.local", "127.0.0.1", 17587, "0009", "1.0", True)])

    def test_missing_records_are_requested(self):
        responder = self.announce(("ball-7", "0007", "127.0.0.1", 17586))
        responder.one_record_each = True
        self.assertEqual([ball.name for ball in hedgehog.discover(3.0)], ["ball-7"])

    def test_a_search_without_a_response_is_an_error_in_both_clients(self):
        self.announce()
        with self.assertRaises(hedgehog.NotConnected) as raised:
            hedgehog.Ball("mdns://", fingerprint=FINGERPRINT)
        self.assertEqual(str(raised.exception), "no ball answers on this network (mDNS, 1 s)")
        self.assertGreater(raised.exception.retry_after_s, 0)

        async def connect():
            async with hedgehog.AsyncBall("mdns://", fingerprint=FINGERPRINT):
                pass

        with self.assertRaisesRegex(hedgehog.NotConnected, "^no ball answers on this network"):
            asyncio.run(connect())

    def test_the_selected_ball_is_connected_to(self):
        # No listener on these ports: the error contains the chosen address.
        self.announce(("ball-7", "0007", "127.0.0.1", 9), ("ball-9", "0009", "127.0.0.1", 10))
        with self.assertRaisesRegex(hedgehog.NotConnected, "^the daemon does not run: tls://127.0.0.1:10: Connection refused$"):
            hedgehog.Ball("mdns://0009", fingerprint=FINGERPRINT)
        with self.assertRaisesRegex(hedgehog.NotConnected, '^several balls .*"ball-7".*"ball-9"'):
            hedgehog.Ball("mdns://", fingerprint=FINGERPRINT)

    def test_nothing_is_searched_for_by_default(self):
        responder = self.announce()
        with mock.patch.dict(os.environ, {"HEDGEHOG_ADDRESS": "127.0.0.1:9"}), self.assertRaises(hedgehog.NotConnected):
            hedgehog.Ball()
        self.assertEqual(responder.queries, 0)


if __name__ == "__main__":
    unittest.main()

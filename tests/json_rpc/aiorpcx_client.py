#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""aiorpcx_client.py PORT: tests Debian's aiorpcX with the daemon on that loopback port. Exit: 0 the responses are as expected."""
import asyncio
import sys
import unittest

import aiorpcx

PULSE = {"direction": "left", "current_a": 5, "duration_ms": 50}


class Session(aiorpcx.RPCSession):
    """Stores the notifications of the daemon."""

    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)
        self.events = asyncio.Queue()

    async def handle_request(self, request):
        assert isinstance(request, aiorpcx.Notification)
        self.events.put_nowait(request)


class Client(unittest.IsolatedAsyncioTestCase):
    port = 0

    async def asyncSetUp(self):
        connection = aiorpcx.connect_rs("127.0.0.1", self.port, session_factory=Session, framer=aiorpcx.NewlineFramer())
        self.session = await self.enterAsyncContext(connection)

    async def next_event(self, what):
        while True:
            event = await self.session.events.get()
            self.assertEqual(event.method, "event")
            if event.args["type"] == what:
                return event.args

    async def test_calls(self):
        hello = await self.session.send_request("hello", {"client": "aiorpcx"})
        self.assertGreater(hello["limits"]["current_a"], 0)
        self.assertGreater((await self.session.send_request("ping"))["time_ns"], 0)
        pulse = await self.session.send_request("effect.pulse", PULSE)
        self.assertTrue(pulse["accepted"])

    async def test_calls_at_once(self):
        responses = await asyncio.gather(*(self.session.send_request("ping") for _ in range(30)))
        self.assertEqual(len([response["time_ns"] for response in responses]), 30)

    async def test_errors(self):
        for method, params, code in (
            ("no.such", {}, -32601),
            ("effect.pulse", {"direction": "sideways"}, -32602),
            ("effect.pulse", ["left"], -32602),
        ):
            with self.assertRaises(aiorpcx.RPCError) as raised:
                await self.session.send_request(method, params)
            self.assertEqual(raised.exception.code, code)

    async def test_notifications_both_ways(self):
        await self.session.send_request("events.subscribe", {"types": ["effect_ended"]})
        await self.session.send_notification("effect.pulse", {**PULSE, "slot": "notified"})
        ended = await self.next_event("effect_ended")
        self.assertEqual((ended["slot"], ended["reason"]), ("notified", "completed"))

    async def test_a_batch(self):
        await self.session.send_request("events.subscribe", {"types": ["effect_ended"]})
        async with self.session.send_batch() as batch:
            batch.add_request("ping")
            batch.add_notification("effect.pulse", {**PULSE, "slot": "batch"})
            batch.add_request("no.such")
        first, second = batch.results
        self.assertGreater(first["time_ns"], 0)
        self.assertEqual(second.code, -32601)
        self.assertEqual((await self.next_event("effect_ended"))["slot"], "batch")


if __name__ == "__main__":
    Client.port = int(sys.argv.pop())
    unittest.main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs conformance.json on the Python library, blocking and asyncio."""

import asyncio
import json
import logging
import os
import pathlib
import subprocess
import sys
import time
import unittest
from unittest import mock

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "clients" / "python"))

import hedgehog  # noqa: E402

CASES = json.loads((HERE / "conformance.json").read_text(encoding="utf-8"))["cases"]
# Timeout of calls, and the duration of a case in which the daemon never answers.
TIMEOUT_S = 60.0
# A line of a client must be shorter than 64 KiB.
FLOOD_BYTES = 30_000
# Far more than what the kernel and the library keep.
FLOOD_LINES = 2000


class Daemon:
    def __init__(self, case):
        self.process = subprocess.Popen([sys.executable, str(HERE / "fake_daemon.py"), case["name"]],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = "127.0.0.1:" + self.process.stdout.readline().strip()

    def finish(self):
        _, errors = self.process.communicate(timeout=60)
        return self.process.returncode, errors


def timeout_of(case):
    return case.get("timeout_s", TIMEOUT_S)


class Reports:
    """The library's reports: number of reconnections, and ended subscriptions."""

    def __init__(self):
        self.reconnections = 0
        self.ended = []
        self.iterators = {}
        self.asked_when_ended = None

    def subscription_ended(self, error):
        assert isinstance(error, hedgehog.SubscriptionEnded) and error.name == "forbidden", repr(error)
        self.ended.append(str(error))
        if self.asked_when_ended:
            self.ask_when_ended(self.asked_when_ended)

    def again(self, hello):
        assert hello["protocol"] == "1.0"
        self.reconnections += 1


class Blocking(Reports):
    """Runs a step of a case on Ball."""

    def __init__(self, ball=None):
        super().__init__()
        self.ball = ball

    async def open(self, address, timeout_s):
        self.ball = hedgehog.Ball(address, name="conformance", timeout_s=timeout_s, on_reconnect=self.again,
                                  on_subscription_ended=self.subscription_ended)

    async def close(self):
        self.ball.close()

    async def call(self, method, params):
        return self.ball.call(method, **params)

    async def notify(self, method, params):
        return self.ball.notify(method, **params)

    async def rumble(self, slot, strength, direction, params):
        return self.ball.rumble(slot, strength, direction, **params)

    def ask_when_ended(self, method):
        self.response = self.ball.call(method)

    async def answer(self):
        return self.response

    async def notification(self):
        return self.ball.next_notification(TIMEOUT_S)

    async def next_of(self, kind):
        if kind not in self.iterators:
            self.iterators[kind] = self.ball.events(timeout_s=TIMEOUT_S) if kind == "events" else self.ball.telemetry(5, timeout_s=TIMEOUT_S)
        return next(self.iterators[kind])


class Asynchronous(Reports):
    """Runs a step of a case on AsyncBall."""

    asked = None

    async def open(self, address, timeout_s):
        self.ball = hedgehog.AsyncBall(address, name="conformance", timeout_s=timeout_s, on_reconnect=self.again,
                                       on_subscription_ended=self.subscription_ended)
        await self.ball.__aenter__()
        # A queue like those from which the generators of events and telemetry read.
        self.queue = asyncio.Queue(100)
        self.ball._subscribers.append(self.queue)

    async def close(self):
        await self.ball.close()

    async def call(self, method, params):
        return await self.ball.call(method, **params)

    async def ask(self, method, params):
        self.asked = asyncio.ensure_future(self.ball.call(method, **params))
        # Runs the task until its first wait, which is after it has sent the request.
        await asyncio.sleep(0)

    def ask_when_ended(self, method):
        self.asked = asyncio.ensure_future(self.ball.call(method))

    async def answer(self):
        # The report of what has ended follows the response that came before it.
        while self.asked is None:
            await asyncio.sleep(0.01)
        return await self.asked

    async def notify(self, method, params):
        return await self.ball.notify(method, **params)

    async def rumble(self, slot, strength, direction, params):
        return await self.ball.rumble(slot, strength, direction, **params)

    async def next_of(self, kind):
        if kind not in self.iterators:
            self.iterators[kind] = self.ball.events() if kind == "events" else self.ball.telemetry(5)
        return await asyncio.wait_for(self.iterators[kind].__anext__(), TIMEOUT_S)

    async def notification(self):
        received = await asyncio.wait_for(self.queue.get(), TIMEOUT_S)
        # Generators end with their connection; this queue continues with the next one.
        return await self.notification() if isinstance(received, hedgehog.BallError) else received


class Conformance(unittest.IsolatedAsyncioTestCase):
    def setUp(self):
        # Its warnings of slow callbacks are caused by the processes that a test starts.
        logging.getLogger("asyncio").setLevel(logging.ERROR)

    async def outcome(self, step, action):
        """Runs the action, whose outcome must be that of the step; returns its result."""
        if "failure" in step:
            with self.assertRaises(hedgehog.NotConnected) as raised:
                await action()
            self.assertIn(step["says"], str(raised.exception))
            if "retry_s" in step:
                self.assertGreaterEqual(raised.exception.retry_after_s, step["retry_s"][0])
                self.assertLessEqual(raised.exception.retry_after_s, step["retry_s"][1])
            return None
        if "error" in step:
            with self.assertRaises(hedgehog.RequestError) as raised:
                await action()
            error, expected = raised.exception, step["error"]
            self.assertEqual((error.code, error.name, str(error)),
                             (expected["code"], expected["name"], expected["message"]))
            self.assertEqual(error.data.get("field"), expected.get("field"))
            return None
        return await action()

    async def again(self, library, method):
        while True:
            try:
                return await library.call(method, {})
            except hedgehog.NotConnected as lost:
                await asyncio.sleep(lost.retry_after_s)

    async def step(self, library, step):
        began = time.monotonic()
        await self.action(library, step)
        self.assertGreaterEqual(time.monotonic() - began, step.get("at_least_s", 0.0))

    async def action(self, library, step):
        params = step.get("params", {})
        if "not_finite" in step:
            with self.assertRaises(ValueError):
                await library.call(step["call"], {**params, step["not_finite"]: float("nan")})
        elif "call" in step:
            result = await self.outcome(step, lambda: library.call(step["call"], params))
            if "result" in step:
                self.assertEqual(result, step["result"])
        elif "call_again" in step:
            self.assertEqual(await self.again(library, step["call_again"]), step["result"])
        elif "ask" in step:
            await library.ask(step["ask"], params)
        elif "answered" in step:
            result = await self.outcome(step, library.answer)
            if "result" in step:
                self.assertEqual(result, step["result"])
        elif "ask_when_ended" in step:
            library.asked_when_ended = step["ask_when_ended"]
        elif "flood" in step:
            for _ in range(FLOOD_LINES):
                if not await library.notify(step["flood"], {"text": "x" * FLOOD_BYTES}):
                    return
            self.fail("what the daemon does not read is kept")
        elif "rumble_again" in step:
            while not await library.rumble(step["rumble_again"], step["strength"], None, params):
                await asyncio.sleep(0.01)
        elif "next_of" in step:
            self.assertEqual(await library.next_of(step["next_of"]), params)
        elif "notify" in step:
            self.assertTrue(await library.notify(step["notify"], params))
        elif "rumble" in step:
            self.assertTrue(await library.rumble(step["rumble"], step["strength"], step.get("direction"), params))
        elif "reconnected" in step:
            self.assertEqual(library.reconnections, step["reconnected"])
        elif "subscriptions_ended" in step:
            self.assertEqual(library.ended, step["subscriptions_ended"])
        else:
            self.assertEqual(await library.notification(), (step["notification"], params))

    def test_an_iterator_raises_once_its_subscription_has_ended(self):
        """The Ball has been reconnected by other calls meanwhile."""
        daemon = Daemon({"name": "a subscription that the next daemon refuses has ended, and is reported"})
        self.addCleanup(lambda: self.assertEqual(daemon.finish(), (0, "")))
        with hedgehog.Ball(daemon.address, timeout_s=TIMEOUT_S) as ball:
            events = ball.events(scope="all")
            telemetry = ball.telemetry(5, timeout_s=0)
            with self.assertRaises(hedgehog.NotConnected):
                ball.ping()
            asyncio.run(self.again(Blocking(ball), "ping"))
            with self.assertRaisesRegex(hedgehog.SubscriptionEnded, "events.subscribe: not any more") as raised:
                next(events)
            self.assertEqual((raised.exception.method, raised.exception.code), ("events.subscribe", hedgehog.ErrorCode.FORBIDDEN))
            self.assertEqual(list(telemetry), [], "that one goes on")
            with self.assertRaises(hedgehog.NotConnected):
                ball.ping()
            asyncio.run(self.again(Blocking(ball), "ping"))

    async def play(self, case, library):
        environment = mock.patch.dict(os.environ, case.get("environment", {}))
        environment.start()
        self.addCleanup(environment.stop)
        daemon = Daemon(case)
        steps = case["client"]
        if "open" in steps[0]:
            await self.outcome(steps[0], lambda: library.open(daemon.address, timeout_of(case)))
        else:
            await library.open(daemon.address, timeout_of(case))
            for step in steps:
                await self.step(library, step)
            await library.close()
        self.assertEqual(await asyncio.to_thread(daemon.finish), (0, ""))


NAMES = {Blocking: "Python Ball", Asynchronous: "Python AsyncBall"}


def report(case, library, passed):
    """Writes a line for the table of run.sh."""
    table = os.environ.get("HEDGEHOG_CONFORMANCE_TABLE")
    if table:
        with open(table, "a", encoding="utf-8") as lines:
            lines.write("%s\t%s\t%s\n" % (NAMES[library], case["name"], "ok" if passed else "failed"))


def add(case, library):
    async def test(self):
        passed = False
        try:
            await self.play(case, library())
            passed = True
        finally:
            report(case, library, passed)
    name = "".join(c if c.isalnum() else "_" for c in case["name"])
    setattr(Conformance, "test_%s_%s" % (library.__name__.lower(), name), test)


for one in CASES:
    for each, each_name in NAMES.items():
        if each_name not in one.get("without", []):
            add(one, each)

if __name__ == "__main__":
    unittest.main()

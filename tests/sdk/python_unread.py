#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Python's Ball, whose calls go one after the other, and a daemon that does not read what it is sent."""

import json
import pathlib
import socket
import sys
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "clients" / "python"))

import hedgehog  # noqa: E402

# A line of a client must be shorter than 64 KiB.
FLOOD_BYTES = 30_000
# Far more than what the kernel keeps.
FLOOD_LINES = 2000


class Unread(unittest.TestCase):
    def test_a_notification_waits_for_the_timeout_while_the_daemon_does_not_read(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            connections = []

            def greet():
                connections.append(server.accept()[0])
                hello = json.loads(connections[0].makefile().readline())
                connections[0].sendall(json.dumps({"jsonrpc": "2.0", "id": hello["id"], "result": {"protocol": "1.0"}}).encode() + b"\n")

            daemon = threading.Thread(target=greet)
            daemon.start()
            with hedgehog.Ball("127.0.0.1:%d" % server.getsockname()[1], timeout_s=3.0) as ball:
                daemon.join()
                sent = [True]
                while sent[-1] and len(sent) < FLOOD_LINES:
                    began = time.monotonic()
                    sent.append(ball.notify("of_the_future", text="x" * FLOOD_BYTES))
                self.assertFalse(sent[-1], "what the kernel does not keep")
                self.assertGreaterEqual(time.monotonic() - began, 3.0)
                self.assertFalse(ball.notify("of_the_future"), "there is no connection any more")
            connections[0].close()


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""record.py HEDGEHOGD CPP_SESSION FOLDER: records what the session of each client library sends and receives.

Each session has a simulated daemon of its own. FOLDER/LIBRARY_1_0.txt gets a line for each message: "→ request", "← response or
notification"; the number is that of the daemon's protocol. Fails if a session does not call every method that the daemon has.
"""

import json
import os
import pathlib
import socket
import subprocess
import sys
import threading

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import live_daemon  # noqa: E402

NOTIFICATIONS = {"events": "event", "telemetry": "telemetry"}


class RecordedAddress:
    """Leads one connection to a daemon, and keeps its messages in their order."""

    def __init__(self, target):
        self.messages = []  # ("→" or "←", text)
        self._lock = threading.Lock()
        self._server = socket.create_server(("127.0.0.1", 0))
        self.text = "127.0.0.1:%d" % self._server.getsockname()[1]
        host, _, port = target.partition(":")
        self._target = (host, int(port))
        self._thread = threading.Thread(target=self._forward, daemon=True)
        self._thread.start()

    def end(self):
        """The connection has ended, or there was none."""
        self._server.shutdown(socket.SHUT_RDWR)
        self._thread.join(live_daemon.LIMIT_S)
        self._server.close()
        return self.messages

    def _forward(self):
        try:
            client, _ = self._server.accept()
        except OSError:
            return
        with client, socket.create_connection(self._target) as daemon:
            back = threading.Thread(target=self._pump, args=(daemon, client, "←"), daemon=True)
            back.start()
            self._pump(client, daemon, "→")
            back.join()

    def _pump(self, source, sink, arrow):
        try:
            for line in source.makefile("rb"):
                # A response is kept after its request, which is kept before it is sent on.
                with self._lock:
                    self.messages.append((arrow, line.decode("utf-8").rstrip("\n")))
                    sink.sendall(line)
            sink.shutdown(socket.SHUT_WR)
        except OSError:
            pass


def arranged(messages):
    """Lines that a player can wait for one by one: the response behind its request, then the notifications before the next one.

    Of telemetry the first after each request, and of a subscription none once its end was asked for: whether they come is a matter
    of time.
    """
    responses = {}
    for arrow, text in messages:
        message = json.loads(text)
        if arrow == "←" and "method" not in message:
            responses[message["id"]] = text
    lines, ended, seen = [], set(), set()
    for arrow, text in messages:
        message = json.loads(text)
        if arrow == "→":
            lines.append("→ " + text)
            if "id" in message:
                lines.append("← " + responses[message["id"]])
            group, _, verb = message["method"].partition(".")
            if verb == "unsubscribe":
                ended.add(NOTIFICATIONS[group])
            elif verb == "subscribe":
                ended.discard(NOTIFICATIONS[group])
            seen = set()
        elif message.get("method") == "telemetry" and "telemetry" not in ended | seen:
            lines.append("← " + text)
            seen.add("telemetry")
        elif message.get("method") == "event" and "event" not in ended:
            lines.append("← " + text)
    return lines


def record(program, command):
    daemon = live_daemon.LiveDaemon(program)
    recorded = RecordedAddress(daemon.address)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("HEDGEHOG_")}
    try:
        subprocess.run([*command, recorded.text], check=True, timeout=live_daemon.LIMIT_S,
                       env=dict(environment, HEDGEHOG_PATIENCE_MS="60000", PYTHONDONTWRITEBYTECODE="1"))
    finally:
        messages = recorded.end()
        daemon.stop()
    return messages


def main(program, cpp_session, folder):
    sessions = {"cpp": [cpp_session], "python": [sys.executable, HERE / "session.py"], "javascript": ["node", HERE / "session.mjs"]}
    failed = False
    for library, command in sessions.items():
        messages = record(program, command)
        hello = next(json.loads(text)["result"] for arrow, text in messages if arrow == "←")
        called = {json.loads(text)["method"] for arrow, text in messages if arrow == "→"}
        missing = sorted(set(hello["methods"]) - called)
        failed = failed or bool(missing)
        lines = arranged(messages)
        path = pathlib.Path(folder, "%s_%s.txt" % (library, hello["protocol"].replace(".", "_")))
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        print("%s: %d lines, %d of %d methods%s" % (path.name, len(lines), len(hello["methods"]) - len(missing), len(hello["methods"]),
                                                    "; not called: " + " ".join(missing) if missing else ""))
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))

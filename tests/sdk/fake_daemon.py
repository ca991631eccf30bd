#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The daemon's side of a case of conformance.json: fake_daemon.py NAME [--websocket]. Prints its port; ends when the case has
been played: exit 0, or 1 with an error message when the client's message is not the one that the case expects."""

import json
import pathlib
import select
import socket
import sys

from websocket import WebSocketLines

HELLO = {"server": "fake", "protocol": "1.0", "role": "operate",
         "limits": {"current_a": 15.0, "continuous_a": 5.0, "felt_a": 2.1, "burst_s": 22.0}}


class Refused(Exception):
    pass


def line_of(message):
    return json.dumps(message, ensure_ascii=False).encode("utf-8") + b"\n"


def is_same(name, value, expected):
    if isinstance(expected, float):
        return abs(value - expected) < 1e-9
    # "1" and "1.0" are the same version.
    return value in (expected, expected + ".0") if name == "protocol" else value == expected


def check(expected, message):
    if message.get("method") != expected["method"]:
        raise Refused("expected %s, came %s" % (expected["method"], message.get("method")))
    if ("id" in message) != expected.get("has_id", True):
        raise Refused("%s: the id is %s" % (expected["method"], "there" if "id" in message else "missing"))
    if "params" in expected:
        params = message.get("params", {})
        same = params.keys() == expected["params"].keys() and all(
            is_same(name, params[name], value) for name, value in expected["params"].items())
        if not same:
            raise Refused("%s: parameters %s" % (expected["method"], json.dumps(params)))


class Lines:
    """A connection with a message on each line, as on TCP."""

    def __init__(self, connection):
        self._stream = connection.makefile("rb")
        self.readline = self._stream.readline
        self.close = self._stream.close

    @staticmethod
    def encode(data):
        return data


def send(connection, data, piece):
    for at in range(0, len(data), piece or len(data)):
        connection.sendall(data[at:at + (piece or len(data))])


def turn_away(error, connection, lines, at_once):
    """As a daemon that has no place for another client: the client's message, if it has come, is not read."""
    if not at_once:
        select.select([connection], [], [], 60)
    connection.sendall(lines.encode(line_of({"jsonrpc": "2.0", "id": None, "error": error})))


def play(step, connection, lines, unanswered):
    """`unanswered`: ids of earlier requests, by the names in their steps."""
    if "turn_away" in step:
        turn_away(step["turn_away"], connection, lines, step.get("at_once"))
        return
    if step == "hello":
        step = {"expect": {"method": "hello"}, "result": HELLO}
    text = lines.readline()
    if not text:
        raise Refused("the client went before %s" % step["expect"]["method"])
    message = json.loads(text)
    check(step["expect"], message)
    if "later" in step:
        unanswered[step["later"]] = message["id"]
    for name, response in step.get("answers", {}).items():
        connection.sendall(lines.encode(line_of({"jsonrpc": "2.0", "id": unanswered.pop(name), **response})))
    for other in step.get("send", []):
        connection.sendall(lines.encode(line_of(other)))
    if "raw" in step:
        connection.sendall(lines.encode(step["raw"].encode("utf-8")))
    for kind in ("result", "error"):
        if kind in step:
            send(connection, lines.encode(line_of({"jsonrpc": "2.0", "id": message["id"], kind: step[kind]})),
                 step.get("piece_bytes", 0))
    for other in step.get("after", []):
        connection.sendall(lines.encode(line_of(other)))


def main():
    text = (pathlib.Path(__file__).parent / "conformance.json").read_text(encoding="utf-8")
    case = next(c for c in json.loads(text)["cases"] if c["name"] == sys.argv[1])
    server = socket.create_server(("127.0.0.1", 0))
    server.settimeout(60)
    print(server.getsockname()[1], flush=True)
    unread = []
    try:
        for steps in case["connections"]:
            connection, _ = server.accept()
            connection.settimeout(60)
            lines = (WebSocketLines if "--websocket" in sys.argv[2:] else Lines)(connection)
            unanswered = {}
            for step in steps:
                play(step, connection, lines, unanswered)
            if isinstance(steps[-1], dict) and steps[-1].get("unread"):
                unread.append((connection, lines))
                continue
            # The client closes the connection, unless in this case the daemon does.
            if not (isinstance(steps[-1], dict) and steps[-1].get("close")):
                while lines.readline():
                    pass
            lines.close()
            connection.close()
    except Refused as refused:
        print(refused, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

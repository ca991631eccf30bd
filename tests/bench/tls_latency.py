#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tls_latency.py BUILD [ROUNDS]: round trips of `ping` and `effect.pulse`, and a new connection up to the response to `hello`, over TLS,
and over WebSocket with TLS, beside TCP.

The simulated daemon of BUILD is measured by all three in turn in each round (11 by default) and the results are compared within
their round, so that all have the same load of the machine. Prints the medians over the rounds, and the range of the quotients."""
import contextlib
import hashlib
import json
import os
import pathlib
import signal
import socket
import ssl
import statistics
import struct
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "sdk"))

from live_daemon import LiveDaemon  # noqa: E402

REQUESTS, PULSES, CONNECTIONS = 2000, 500, 20
PING = b'{"jsonrpc":"2.0","id":1,"method":"ping"}'
# In a slot, so that each replaces the last.
PULSE = (b'{"jsonrpc":"2.0","id":1,"method":"effect.pulse",'
         b'"params":{"direction":"left","current_a":0.1,"duration_ms":5,"slot":"latency"}}')
ROWS = ("`ping`, p50", "`ping`, p99", "`effect.pulse`, p50", "connect and `hello`, p50")


class Lines:
    """A connection over TCP, or TLS: a message is a line."""

    def __init__(self, daemon, address):
        scheme, _, place = address.rpartition("://")
        host, port = place.split(":")
        self._socket = socket.create_connection((host, int(port)))
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if scheme:
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
            context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
            self._socket = context.wrap_socket(self._socket)
            if hashlib.sha256(self._socket.getpeercert(binary_form=True)).hexdigest() != daemon.fingerprint:
                raise RuntimeError("another certificate than that of the daemon")

    def encode(self, message):
        return message + b"\n"

    def exchange(self, encoded):
        """Sends what `encode` returned; returns the response's message."""
        self._socket.sendall(encoded)
        return self._receive(lambda text: len(text) if text.endswith(b"\n") else 0)

    def close(self):
        self._socket.close()

    def _receive(self, length):
        """Receives until `length` of what has come is not 0."""
        text = b""
        while not length(text):
            part = self._socket.recv(65536)
            if not part:
                raise RuntimeError("the daemon closed the connection")
            text += part
        return text


class WebSocket(Lines):
    """A connection over HTTPS that has become a WebSocket: a message is a text frame."""

    def __init__(self, daemon, address):
        super().__init__(daemon, address)
        self._socket.sendall(b"GET /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             b"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n")
        response = self._receive(lambda text: text.find(b"\r\n\r\n") + 1)
        if b" 101 " not in response:
            raise RuntimeError(response.decode("ascii", "replace"))

    def encode(self, message):
        # Masked by zeros, as a client that spends no time on it would.
        size = bytes([0x80 | len(message)]) if len(message) < 126 else struct.pack("!BH", 0xFE, len(message))
        return b"\x81" + size + bytes(4) + message

    def exchange(self, encoded):
        self._socket.sendall(encoded)
        frame = self._receive(self._complete)
        return frame[4:] if frame[1] == 126 else frame[2:]

    @staticmethod
    def _complete(frame):
        if len(frame) < 4:
            return False
        header, size = (4, struct.unpack_from("!H", frame, 2)[0]) if frame[1] == 126 else (2, frame[1])
        return len(frame) >= header + size


def connect(daemon, transport):
    """A connection that has received the response to `hello`."""
    kind, address = transport
    connection = kind(daemon, address)
    hello = {"jsonrpc": "2.0", "id": 0, "method": "hello", "params": {"client": "latency", "token": daemon.token}}
    response = json.loads(connection.exchange(connection.encode(json.dumps(hello).encode())))
    if "result" not in response:
        raise RuntimeError(str(response))
    return connection


def timed(act, count):
    """Returns the duration of each of `count` calls, µs."""
    times = []
    for _ in range(count):
        begun = time.perf_counter_ns()
        act()
        times.append((time.perf_counter_ns() - begun) / 1000)
    return times


def measure(daemon, connection, transport):
    """The figures of ROWS, µs."""
    ping, pulse = connection.encode(PING), connection.encode(PULSE)
    pings = timed(lambda: connection.exchange(ping), REQUESTS)
    responses = []
    pulses = timed(lambda: responses.append(connection.exchange(pulse)), PULSES)
    for response in responses:
        if "result" not in json.loads(response):
            raise RuntimeError(str(response))
    opened = timed(lambda: connect(daemon, transport).close(), CONNECTIONS)
    return statistics.median(pings), statistics.quantiles(pings, n=100)[98], statistics.median(pulses), statistics.median(opened)


def print_table(rounds):
    """`rounds`: the figures over TCP, TLS and WebSocket with TLS, of each round."""
    print(f"{len(rounds)} rounds, µs, medians; quotients are those of each round, with their range\n")
    print("| | TCP | TLS 1.3 | beside TCP | WebSocket, TLS 1.3 | beside TCP |\n|---|---|---|---|---|---|")
    for row, name in enumerate(ROWS):
        tcp, *others = ([each[kind][row] for each in rounds] for kind in range(3))
        cells = [f"{statistics.median(tcp):.1f}"]
        for figures in others:
            quotients = [b / a for a, b in zip(tcp, figures)]
            cells += [f"{statistics.median(figures):.1f}",
                      f"{statistics.median(quotients):.2f} × ({min(quotients):.2f}–{max(quotients):.2f})"]
        print(f"| {name} | {' | '.join(cells)} |")


def main(build, rounds=11):
    # So that SIGTERM also ends the daemon.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    daemon = LiveDaemon(os.path.join(build, "daemon/hedgehogd"), pages="tls://127.0.0.1:0")
    transports = ((Lines, daemon.address), (Lines, daemon.tls_address), (WebSocket, daemon.pages_address))
    try:
        with contextlib.ExitStack() as open_ones:
            connections = [open_ones.enter_context(contextlib.closing(connect(daemon, one))) for one in transports]
            print_table([[measure(daemon, *pair) for pair in zip(connections, transports)] for _ in range(int(rounds))])
    finally:
        daemon.stop()


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        sys.exit(64)
    main(*sys.argv[1:])

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tls_latency.py BUILD [ROUNDS]: round trips of `ping` and `effect.pulse`, and a new connection up to the response to `hello`, over TLS
beside TCP.

The simulated daemon of BUILD is measured by both in turn in each round (11 by default) and the results are compared within
their round, so that both have the same load of the machine. Prints the medians over the rounds, and the range of the quotients."""
import contextlib
import hashlib
import json
import os
import pathlib
import signal
import socket
import ssl
import statistics
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "sdk"))

from live_daemon import LiveDaemon  # noqa: E402

REQUESTS, PULSES, CONNECTIONS = 2000, 500, 20
PING = b'{"jsonrpc":"2.0","id":1,"method":"ping"}\n'
# In a slot, so that each replaces the last.
PULSE = (b'{"jsonrpc":"2.0","id":1,"method":"effect.pulse",'
         b'"params":{"direction":"left","current_a":0.1,"duration_ms":5,"slot":"latency"}}\n')
ROWS = ("`ping`, p50", "`ping`, p99", "`effect.pulse`, p50", "connect and `hello`, p50")


def exchange(connection, line):
    connection.sendall(line)
    response = b""
    while not response.endswith(b"\n"):
        part = connection.recv(65536)
        if not part:
            raise RuntimeError("the daemon closed the connection")
        response += part
    return response


def connect(daemon, tls):
    """A connection that has received the response to `hello`."""
    host, port = (daemon.tls_address if tls else daemon.address).removeprefix("tls://").split(":")
    connection = socket.create_connection((host, int(port)))
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    if tls:
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
        connection = context.wrap_socket(connection)
        if hashlib.sha256(connection.getpeercert(binary_form=True)).hexdigest() != daemon.fingerprint:
            raise RuntimeError("another certificate than that of the daemon")
    hello = {"jsonrpc": "2.0", "id": 0, "method": "hello", "params": {"client": "latency", "token": daemon.token}}
    response = json.loads(exchange(connection, json.dumps(hello).encode() + b"\n"))
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


def measure(daemon, connection, tls):
    """The figures of ROWS, µs."""
    pings = timed(lambda: exchange(connection, PING), REQUESTS)
    responses = []
    pulses = timed(lambda: responses.append(exchange(connection, PULSE)), PULSES)
    for response in responses:
        if "result" not in json.loads(response):
            raise RuntimeError(str(response))
    opened = timed(lambda: connect(daemon, tls).close(), CONNECTIONS)
    return statistics.median(pings), statistics.quantiles(pings, n=100)[98], statistics.median(pulses), statistics.median(opened)


def print_table(rounds):
    """`rounds`: the figures over TCP and over TLS, of each round."""
    print(f"{len(rounds)} rounds, µs, medians; quotients are those of each round, with their range\n")
    print("| | TCP | TLS 1.3 | beside TCP |\n|---|---|---|---|")
    for row, name in enumerate(ROWS):
        tcp, tls = ([each[kind][row] for each in rounds] for kind in (0, 1))
        quotients = [b / a for a, b in zip(tcp, tls)]
        print(f"| {name} | {statistics.median(tcp):.1f} | {statistics.median(tls):.1f} | {statistics.median(quotients):.2f} × "
              f"({min(quotients):.2f}–{max(quotients):.2f}) |")


def main(build, rounds=11):
    # So that SIGTERM also ends the daemon.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    daemon = LiveDaemon(os.path.join(build, "daemon/hedgehogd"))
    try:
        with contextlib.closing(connect(daemon, False)) as tcp, contextlib.closing(connect(daemon, True)) as tls:
            print_table([(measure(daemon, tcp, False), measure(daemon, tls, True)) for _ in range(int(rounds))])
    finally:
        daemon.stop()


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        sys.exit(64)
    main(*sys.argv[1:])

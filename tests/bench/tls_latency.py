#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tls_latency.py BUILD [ROUNDS]: the round trip of `ping` over TLS beside that over TCP and the Unix socket.

Starts the simulated daemon of BUILD with a token and a self-signed certificate. The transports are measured in turn in each
round, 2,000 requests each, and compared within their round, so that both have the same load of the machine; so are new
connections up to the answer to `hello`. Prints the medians over the rounds, and the range of the comparison."""
import hashlib
import json
import os
import pathlib
import signal
import socket
import ssl
import statistics
import subprocess
import sys
import tempfile
import time

REQUESTS, CONNECTIONS = 2000, 20
PING = b'{"jsonrpc":"2.0","id":1,"method":"ping"}\n'


def percentile(sorted_values, share):
    return sorted_values[min(len(sorted_values) - 1, int(share * len(sorted_values)))]


class Daemon:
    def __init__(self, build, folder):
        env = dict(os.environ, HOME=str(folder), XDG_RUNTIME_DIR=str(folder), XDG_STATE_HOME=str(folder / "state"),
                   XDG_CONFIG_HOME=str(folder / "config"))
        ctl = [build / "clients/ctl/hedgehogctl", "token"]
        state = ["--state", folder / "state/hedgehog"]
        (folder / "state/hedgehog").mkdir(parents=True)
        subprocess.run([*ctl, "certificate", *state, "--host", "localhost"], check=True, capture_output=True, env=env)
        added = subprocess.run([*ctl, "add", "latency", "--role", "play", "--json", *state], check=True, capture_output=True, env=env)
        self.token = json.loads(added.stdout)["token"]
        self.fingerprint = self._fingerprint(folder / "state/hedgehog/certificate.pem")
        self.command = [build / "daemon/hedgehogd", "--simulate", "--listen", "127.0.0.1:0", "--listen", "tls://127.0.0.1:0"]
        self.env, self.process, self.ports = env, None, {}

    def start(self):
        self.process = subprocess.Popen(self.command, env=self.env, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        for line in self.process.stdout:
            where = line.rsplit(" ", 1)[-1].strip()
            if "listening on" not in line:
                continue
            if where.startswith("/"):
                self.path = where
                break
            if not where.startswith("http"):
                self.ports["TLS 1.3" if where.startswith("tls://") else "TCP"] = int(where.rsplit(":", 1)[1])

    @staticmethod
    def _fingerprint(file):
        return hashlib.sha256(ssl.PEM_cert_to_DER_cert(file.read_text())).digest()

    def connect(self, transport):
        """A connection that has been answered to `hello`."""
        if transport == "Unix socket":
            connection = socket.socket(socket.AF_UNIX)
            connection.connect(self.path)
        else:
            connection = socket.create_connection(("127.0.0.1", self.ports[transport]))
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if transport == "TLS 1.3":
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
            context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
            connection = context.wrap_socket(connection)
            if hashlib.sha256(connection.getpeercert(binary_form=True)).digest() != self.fingerprint:
                sys.exit("tls_latency.py: another certificate than that of the daemon")
        hello = {"jsonrpc": "2.0", "id": 0, "method": "hello", "params": {"client": "latency", "token": self.token}}
        answer = json.loads(exchange(connection, json.dumps(hello).encode() + b"\n"))
        if "result" not in answer:
            sys.exit(f"tls_latency.py: {answer}")
        return connection

    def end(self):
        if self.process:
            self.process.terminate()
            self.process.wait()


def exchange(connection, line):
    connection.sendall(line)
    answer = connection.recv(65536)
    while not answer.endswith(b"\n"):
        more = connection.recv(65536)
        if not more:
            sys.exit("tls_latency.py: the daemon closed the connection")
        answer += more
    return answer


def timed(act, count):
    """Sorted, µs."""
    times = []
    for _ in range(count):
        begun = time.perf_counter_ns()
        act()
        times.append((time.perf_counter_ns() - begun) / 1000)
    return sorted(times)


def measure(daemon, rounds):
    """{(row, transport): [value of each round]}"""
    figures = {}
    transports = ("TCP", "TLS 1.3", "Unix socket")
    connections = {transport: daemon.connect(transport) for transport in transports}
    for _ in range(rounds):
        for transport in transports:
            pings = timed(lambda: exchange(connections[transport], PING), REQUESTS)
            opened = timed(lambda: daemon.connect(transport).close(), CONNECTIONS)
            for row, value in (("ping, p50", percentile(pings, 0.5)), ("ping, p99", percentile(pings, 0.99)),
                               ("connect and hello, p50", percentile(opened, 0.5))):
                figures.setdefault((row, transport), []).append(value)
    return figures


def print_table(figures, rounds):
    print(f"{rounds} rounds, µs, medians; quotients are those of each round, with their range\n")
    print("| | TCP | TLS 1.3 | beside TCP | Unix socket | beside TCP |\n|---|---|---|---|---|---|")
    for row in dict.fromkeys(row for row, _ in figures):
        tcp = figures[row, "TCP"]
        cells = [f"{statistics.median(tcp):.1f}"]
        for transport in ("TLS 1.3", "Unix socket"):
            values = figures[row, transport]
            quotients = sorted(value / base for value, base in zip(values, tcp))
            cells.append(f"{statistics.median(values):.1f}")
            cells.append(f"{statistics.median(quotients):.2f} × ({quotients[0]:.2f}–{quotients[-1]:.2f})")
        print(f"| {row} | " + " | ".join(cells) + " |")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    # So that the daemon is ended too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    rounds = int(sys.argv[2]) if len(sys.argv) == 3 else 11
    with tempfile.TemporaryDirectory() as folder:
        daemon = Daemon(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(folder))
        try:
            daemon.start()
            print_table(measure(daemon, rounds), rounds)
        finally:
            daemon.end()


if __name__ == "__main__":
    main()

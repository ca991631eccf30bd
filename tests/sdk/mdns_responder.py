#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mdns_responder.py NAME SERIAL ADDRESS PORT ...: announces these balls by multicast DNS on the loopback interface, on a free
port, which it prints; for clients with HEDGEHOG_MDNS_PORT. Ends when its stdin is closed."""

import socket
import struct
import sys
import threading

GROUP = "224.0.0.251"
SERVICE = b"\x09_hedgehog\x04_tcp\x05local\x00"
HOST = b"\x03lab\x05local\x00"
A, PTR, TXT, SRV = 1, 12, 16, 33


def _record(name, kind, data):
    return name + struct.pack(">HHIH", kind, 1, 10, len(data)) + data


def _records(name, serial, address, port):
    label = name.encode()
    instance = bytes((len(label),)) + label + SERVICE
    entries = [entry.encode() for entry in ("protocol=1.0", "serial=" + serial, "tls=1")]
    return [(SERVICE, PTR, _record(SERVICE, PTR, instance)),
            (instance, SRV, _record(instance, SRV, struct.pack(">3H", 0, 0, port) + HOST)),
            (instance, TXT, _record(instance, TXT, b"".join(bytes((len(entry),)) + entry for entry in entries))),
            (HOST, A, _record(HOST, A, socket.inet_aton(address)))]


class Responder:
    """Answers queries in a separate thread until close()."""

    def __init__(self, balls):
        self._balls = [_records(*ball) for ball in balls]
        #: If true, sends only the requested records, each in a separate response.
        self.one_record_each = False
        self.queries = 0
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("", 0))
        self._socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(GROUP) + socket.inet_aton("127.0.0.1"))
        self.port = self._socket.getsockname()[1]
        self._thread = threading.Thread(target=self._serve)
        self._thread.start()

    def close(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as own:
            own.sendto(b"", ("127.0.0.1", self.port))
        self._thread.join()
        self._socket.close()

    def _serve(self):
        while True:
            query, sender = self._socket.recvfrom(9000)
            if not query:
                return
            self.queries += 1
            for records in self._balls:
                if self.one_record_each:
                    answers = [[data] for name, kind, data in records if name + struct.pack(">H", kind) in query]
                else:
                    answers = [[data for _, _, data in records]]
                for answer in answers:
                    self._socket.sendto(query[:2] + struct.pack(">5H", 0x8400, 0, len(answer), 0, 0) + b"".join(answer), sender)


def main():
    given = sys.argv[1:]
    balls = [(given[i], given[i + 1], given[i + 2], int(given[i + 3])) for i in range(0, len(given), 4)]
    responder = Responder(balls)
    print(responder.port, flush=True)
    sys.stdin.read()
    responder.close()


if __name__ == "__main__":
    main()

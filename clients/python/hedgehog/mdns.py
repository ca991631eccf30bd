# SPDX-License-Identifier: MIT
"""Multicast DNS as far as one search needs it (RFC 6762, RFC 6763), without I/O. What is read came from the network: a
message that is malformed anywhere counts for nothing, and texts have no control characters."""

import ipaddress
import struct
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

#: Names are in the uncompressed form of RFC 1035: a byte of length before each label, 0 at the end.
SERVICE = b"\x09_hedgehog\x04_tcp\x05local\x00"

_A, _PTR, _TXT, _AAAA, _SRV, _IN = 1, 12, 16, 28, 33, 1
#: Of the class of a question: the response may be unicast. Of a record: it replaces others.
_TOP_BIT = 0x8000
_MAX_NAME = 255
#: That one name leads through: each record may walk the whole chain again.
_MAX_POINTERS = 32
#: RFC 6762, section 17; IP's and UDP's headers included.
_MAX_MESSAGE = 9000
#: Of instances, and of names with services, texts or addresses each; further ones are ignored.
_MAX_NAMES = 256
_MAX_ADDRESSES = 16
#: Of a query; what does not fit is asked for later.
_MAX_QUERY = 1200


class DiscoveredBall(NamedTuple):
    """A ball that has announced itself, at one of its addresses.

    address: of its host, in digits. serial, protocol: None: it announces none. tls: what it announces; the daemon always does.
    """

    name: str
    host: str
    address: str
    port: int
    serial: Optional[str]
    protocol: Optional[str]
    tls: bool


class _Malformed(Exception):
    pass


class _Message:
    """Reads one message from its first byte to its last."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self.at = 0

    def take(self, size: int) -> bytes:
        taken = self._data[self.at:self.at + size]
        if len(taken) != size:
            raise _Malformed
        self.at += size
        return taken

    def numbers(self, layout: str) -> Tuple[int, ...]:
        return struct.unpack(layout, self.take(struct.calcsize(layout)))

    def name(self) -> bytes:
        name = b""
        end: Optional[int] = None
        begin = self.at
        pointers = 0
        while True:
            (size,) = self.take(1)
            if size >= 0xC0:
                target = (size & 0x3F) << 8 | self.take(1)[0]
                # Always further back: no name goes round in circles.
                pointers += 1
                if target >= begin or pointers > _MAX_POINTERS:
                    raise _Malformed
                end = self.at if end is None else end
                self.at = begin = target
                continue
            if size > 63 or len(name) + 1 + size > _MAX_NAME:
                raise _Malformed
            name += bytes((size,)) + self.take(size)
            if size == 0:
                self.at = self.at if end is None else end
                return name


def printable(text: bytes) -> str:
    """Any machine of the network wrote it: nothing that moves a terminal's cursor."""
    return "".join("?" if c < " " or "\x7f" <= c <= "\x9f" else c for c in text.decode("utf-8", "replace"))


def _labels(name: bytes) -> List[bytes]:
    labels = []
    while name[0]:
        labels.append(name[1:1 + name[0]])
        name = name[1 + name[0]:]
    return labels


class Answers:
    """What has been answered to one search so far. Names are compared as DNS does, without regard to case."""

    def __init__(self, search: int) -> None:
        """search: the id, 0 to 65535, of its queries and of the responses that count."""
        self._id = search
        self._instances: Dict[bytes, bytes] = {}
        self._services: Dict[bytes, Tuple[bytes, int]] = {}
        self._texts: Dict[bytes, Dict[bytes, bytes]] = {}
        self._addresses: Dict[bytes, List[str]] = {}

    def query(self) -> bytes:
        """Asks for the service, and for what is missing of those that have answered."""
        questions = [(SERVICE, _PTR)]
        for key, instance in self._instances.items():
            service = self._services.get(key)
            if service is None:
                questions.append((instance, _SRV))
            elif service[0].lower() not in self._addresses:
                questions.append((service[0], _A))
            if key not in self._texts:
                questions.append((instance, _TXT))
        body = b""
        count = 0
        for name, kind in questions:
            question = name + struct.pack(">HH", kind, _IN | _TOP_BIT)
            if 12 + len(body) + len(question) <= _MAX_QUERY:
                body += question
                count += 1
        return struct.pack(">6H", self._id, 0, count, 0, 0, 0) + body

    def read(self, packet: bytes) -> bool:
        """Whether something in that datagram was of interest."""
        if len(packet) > _MAX_MESSAGE:
            return False
        try:
            records = self._records(_Message(packet))
        except _Malformed:
            return False
        for name, kind, value in records:
            self._keep(name.lower(), kind, value)
        return bool(records)

    def balls(self) -> List[DiscoveredBall]:
        """Those of which a host, a port and an address are known, by name."""
        found = []
        for key, instance in self._instances.items():
            host, port = self._services.get(key, (b"\x00", 0))
            texts = self._texts.get(key, {})
            if port == 0:
                continue
            for address in self._addresses.get(host.lower(), []):
                found.append(DiscoveredBall(
                    name=printable(_labels(instance)[0]), host=".".join(map(printable, _labels(host))), address=address, port=port,
                    serial=printable(texts[b"serial"]) if b"serial" in texts else None,
                    protocol=printable(texts[b"protocol"]) if b"protocol" in texts else None, tls=texts.get(b"tls") == b"1"))
        return sorted(found, key=lambda ball: (ball.name, ":" in ball.address, ball.address))

    def _records(self, message: _Message) -> List[Tuple[bytes, int, Any]]:
        search, flags, questions, *counts = message.numbers(">6H")
        # A response to a standard query, without an error.
        if search != self._id or flags & 0xF80F != 0x8000:
            return []
        for _ in range(questions):
            message.name()
            message.take(4)
        records: List[Tuple[bytes, int, Any]] = []
        for _ in range(sum(counts)):
            name = message.name()
            kind, kind_class, lifetime_s, size = message.numbers(">HHIH")
            end = message.at + size
            value = _value(message, kind, end)
            if kind_class & ~_TOP_BIT == _IN and lifetime_s > 0 and value is not None:
                records.append((name, kind, value))
        return records

    def _keep(self, key: bytes, kind: int, value: Any) -> None:
        if kind == _PTR:
            # One label before the service's name.
            if key == SERVICE and value[0] and value[1 + value[0]:].lower() == SERVICE and len(self._instances) < _MAX_NAMES:
                self._instances.setdefault(value.lower(), value)
        elif kind == _SRV and len(self._services) < _MAX_NAMES:
            self._services.setdefault(key, value)
        elif kind == _TXT and len(self._texts) < _MAX_NAMES:
            self._texts.setdefault(key, value)
        elif kind in (_A, _AAAA) and (key in self._addresses or len(self._addresses) < _MAX_NAMES):
            known = self._addresses.setdefault(key, [])
            if value not in known and len(known) < _MAX_ADDRESSES:
                known.append(value)


def _value(message: _Message, kind: int, end: int) -> Any:
    """PTR: a name; SRV: host and port; TXT: its entries; A, AAAA: the address, but for those of a link, which lack their
    interface. None: not of interest."""
    value: Any = None
    if kind == _PTR:
        value = message.name()
    elif kind == _SRV:
        port = message.numbers(">3H")[2]
        value = (message.name(), port)
    elif kind == _TXT:
        entries: Dict[bytes, bytes] = {}
        while message.at < end:
            key, equals, text = message.take(message.take(1)[0]).partition(b"=")
            if equals:
                entries.setdefault(key.lower(), text)
        value = entries
    elif kind == _A:
        value = str(ipaddress.IPv4Address(message.take(4)))
    elif kind == _AAAA:
        address = ipaddress.IPv6Address(message.take(16))
        value = None if address.is_link_local else str(address)
    else:
        message.take(max(0, end - message.at))
    if message.at != end:
        raise _Malformed
    return value

# SPDX-License-Identifier: MIT
"""Balls that announce themselves on the network, found when a program asks for them: `discover`, and addresses that begin
with mdns://. One question by multicast to each IPv4 network of this machine; no other program is needed for it."""

import os
import secrets
import socket
import struct
import sys
import time
from typing import Callable, List, Optional

from .address import Address, MdnsAddress, TlsAddress, describe
from .mdns import Answers, DiscoveredBall

GROUP = "224.0.0.251"
PORT = 5353
#: Of the search for an address that begins with mdns://.
SEARCH_S = 1.0
#: A lost one is replaced by the next, which also asks for what is missing.
QUERIES = 3
#: Balls that an error names.
MAX_LISTED = 8


class BallNotFound(Exception):
    """No ball, or more than one, is meant; a sentence for people."""


def discover(timeout_s: float = 1.0) -> List[DiscoveredBall]:
    """The balls that answer within that time, by name; one that has several addresses is there with each. Takes the whole time.
    Raises OSError when this machine has no network."""
    return _search(timeout_s, None)


def locate(addresses: List[Address]) -> List[Address]:
    """The same with what an address that begins with mdns:// has found. Raises BallNotFound and OSError."""
    located: List[Address] = []
    for address in addresses:
        if isinstance(address, MdnsAddress):
            name = address.name
            found = chosen(name, _search(SEARCH_S, lambda balls: bool(name) and bool(named(name, balls))))
            located += [TlsAddress(ball.address, ball.port, address.fingerprint) for ball in found]
        else:
            located.append(address)
    return located


def named(name: str, balls: List[DiscoveredBall]) -> List[DiscoveredBall]:
    """Those of that name, else those of that serial number. Without TLS nothing is connected to."""
    secure = [ball for ball in balls if ball.tls]
    return [ball for ball in secure if ball.name == name] or [ball for ball in secure if ball.serial == name]


def chosen(name: str, balls: List[DiscoveredBall]) -> List[DiscoveredBall]:
    """The addresses of the one ball that is meant; name: empty: there is only one. Raises BallNotFound."""
    secure = [ball for ball in balls if ball.tls]
    meant = named(name, balls) if name else secure
    if not secure:
        raise BallNotFound("no ball answers on this network (mDNS, 1 s)")
    if not meant:
        raise BallNotFound('no ball "%s" answers on this network (mDNS, 1 s); there are: %s' % (name, _listed(secure)))
    if any(ball.name != meant[0].name for ball in meant):
        raise BallNotFound("several balls answer on this network: %s; choose one by its name or serial number, for example %s"
                           % (_listed(meant), describe(MdnsAddress(meant[0].name, b""))))
    return meant


def _listed(balls: List[DiscoveredBall]) -> str:
    texts = []
    for name in dict.fromkeys(ball.name for ball in balls):
        ball = next(one for one in balls if one.name == name)
        serial = "serial %s, " % ball.serial if ball.serial is not None else ""
        texts.append('"%s" (%s%s)' % (name, serial, describe(TlsAddress(ball.address, ball.port, b""))))
    more = ["and %d more" % (len(texts) - MAX_LISTED)] if len(texts) > MAX_LISTED else []
    return ", ".join(texts[:MAX_LISTED] + more)


def _search(timeout_s: float, enough: Optional[Callable[[List[DiscoveredBall]], bool]]) -> List[DiscoveredBall]:
    """Ends after that time, or when what was found is enough (None: it never is)."""
    answers = Answers(secrets.randbelow(1 << 16))
    begin = time.monotonic()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
        asking.bind(("", 0))
        asking.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 255)
        for query in range(1, QUERIES + 1):
            _ask(asking, answers.query())
            until = begin + timeout_s * query / QUERIES
            while True:
                left_s = until - time.monotonic()
                if left_s <= 0.0:
                    break
                asking.settimeout(left_s)
                try:
                    is_new = answers.read(asking.recv(1 << 14))
                except socket.timeout:
                    break
                if is_new and enough and enough(answers.balls()):
                    return answers.balls()
    return answers.balls()


def _ask(asking: socket.socket, query: bytes) -> None:
    port = _test_port()
    for interface in [socket.inet_aton("127.0.0.1")] if port else _interfaces():
        try:
            asking.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, interface)
            asking.sendto(query, (GROUP, port or PORT))
        except OSError:
            # It is down, or has no IPv4.
            continue


def _interfaces() -> List[bytes]:
    """As IP_MULTICAST_IF takes them, by number."""
    numbers = [number for number, _ in socket.if_nameindex()]
    if sys.platform == "win32":
        return [struct.pack("!I", number) for number in numbers]
    return [struct.pack("@4s4si", bytes(4), bytes(4), number) for number in numbers]


def _test_port() -> Optional[int]:
    """HEDGEHOG_MDNS_PORT: for tests; that port is asked instead, on this machine only."""
    text = os.environ.get("HEDGEHOG_MDNS_PORT", "")
    return int(text) if text.isascii() and text.isdigit() else None

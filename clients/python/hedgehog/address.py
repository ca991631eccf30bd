# SPDX-License-Identifier: MIT
"""Where the daemon listens: $HEDGEHOG_ADDRESS, and nowhere else if it is set; otherwise the sockets in
$RUNTIME_DIRECTORY, /run/hedgehog and $XDG_RUNTIME_DIR/hedgehog (/tmp/hedgehog-UID without these variables), then
127.0.0.1:7586. As every client of Hedgehog. With TLS, $HEDGEHOG_FINGERPRINT is that of the daemon's certificate. Only
"mdns://" searches the network."""

import os
from typing import List, Mapping, NamedTuple, Optional, Tuple, Union

from .errors import AddressError


class TlsAddress(NamedTuple):
    """A host and a port with TLS; fingerprint: SHA-256 of the daemon's certificate, empty: the system's authorities
    vouch for it."""

    host: str
    port: int
    fingerprint: bytes


class MdnsAddress(NamedTuple):
    """A ball that is searched for on the network when a connection is made; name: its name or serial number, empty: the only
    one; fingerprint: of its certificate."""

    name: str
    fingerprint: bytes


#: A host and a port, with TLS or without, a ball on the network, or the path of a Unix socket.
Address = Union[Tuple[str, int], TlsAddress, MdnsAddress, str]

PORT = 7586
SOCKET = "hedgehogd.sock"


def _bad(text: str, why: str) -> AddressError:
    return AddressError("'%s' is no address of a daemon: %s (for example 127.0.0.1:7586, [::1]:7586 or "
                        "/run/hedgehog/hedgehogd.sock)" % (text, why))


def parse_address(text: str) -> Address:
    """"host", "host:port", "[v6]:port", a bare IPv6 address, or "/path", each with "tcp:", "tls://" or "unix:" in front;
    "mdns://" or "mdns://NAME"."""
    if text.startswith("mdns://"):
        return MdnsAddress(text[7:], b"")
    if text.startswith("tls://"):
        host, port = _parse_tcp(text, text[6:])
        return TlsAddress(host, port, b"")
    if text.startswith("unix:") or text.startswith("/"):
        path = text[5:] if text.startswith("unix:") else text
        if not path:
            raise _bad(text, "it names no socket")
        return path
    return _parse_tcp(text, text[4:] if text.startswith("tcp:") else text)


def _parse_tcp(text: str, place: str) -> Tuple[str, int]:
    if place.startswith("["):
        host, closed, rest = place[1:].partition("]")
        if not closed:
            raise _bad(text, "']' is missing")
    elif place.count(":") > 1:
        host, rest = place, ""
    else:
        host, colon, port = place.partition(":")
        rest = colon + port
    if not host:
        raise _bad(text, "it names no host")
    if not rest:
        return host, PORT
    digits = rest[1:]
    if rest[0] != ":" or not (digits.isascii() and digits.isdigit()) or not 1 <= int(digits) <= 65535:
        raise _bad(text, "the port is a number from 1 to 65535")
    return host, int(digits)


def parse_fingerprint(text: str) -> bytes:
    """As `hedgehogctl token certificate` prints it, or with a colon after each pair."""
    try:
        digest = bytes.fromhex(text.replace(":", ""))
    except ValueError:
        digest = b""
    if len(digest) != 32:
        raise AddressError("the fingerprint is invalid: it must have 64 hexadecimal digits, as hedgehogctl token certificate prints it")
    return digest


def daemon_addresses(given: Optional[str] = None, environment: Mapping[str, str] = os.environ,
                     fingerprint: Optional[str] = None) -> List[Address]:
    """In the order in which they are tried."""
    text = given or environment.get("HEDGEHOG_ADDRESS", "")
    if text:
        address = parse_address(text)
        pinned = fingerprint or environment.get("HEDGEHOG_FINGERPRINT", "")
        if isinstance(address, (TlsAddress, MdnsAddress)) and pinned:
            address = address._replace(fingerprint=parse_fingerprint(pinned))
        if isinstance(address, MdnsAddress) and not pinned:
            raise AddressError("mdns:// needs a fingerprint (HEDGEHOG_FINGERPRINT), as hedgehogctl token certificate prints it: "
                               "any machine can announce a ball")
        return [address]
    runtime = environment.get("RUNTIME_DIRECTORY", "")
    session = environment.get("XDG_RUNTIME_DIR", "")
    # systemd may name several, separated by colons: the first is the daemon's.
    folders = [runtime.split(":")[0]] if runtime else []
    folders.append("/run/hedgehog")
    if session:
        folders.append(session + "/hedgehog")
    elif not runtime and hasattr(os, "getuid"):
        # Where a daemon that was started by hand without XDG_RUNTIME_DIR puts it.
        folders.append("/tmp/hedgehog-%d" % os.getuid())
    return [*(folder + "/" + SOCKET for folder in dict.fromkeys(folders)), ("127.0.0.1", PORT)]


def describe(address: Address) -> str:
    if isinstance(address, str):
        return address
    if isinstance(address, MdnsAddress):
        return "mdns://" + address.name
    if isinstance(address, TlsAddress):
        return "tls://" + describe((address.host, address.port))
    host, port = address
    return "[%s]:%d" % (host, port) if ":" in host else "%s:%d" % (host, port)

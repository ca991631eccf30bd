# SPDX-License-Identifier: MIT
"""Connecting a socket to an address of the daemon, within a time limit."""

import socket
import time
from typing import Tuple

from .address import Address, MdnsAddress, TlsAddress
from .backoff import share_of
from .tls import check_certificate, tls_context


def open_socket(address: Address, timeout_s: float) -> socket.socket:
    """A connection to that address, with TLS where it says so. Raises OSError."""
    if isinstance(address, TlsAddress):
        deadline = time.monotonic() + timeout_s
        plain = open_socket((address.host, address.port), timeout_s)
        try:
            plain.settimeout(share_of(deadline))
            wrapped = tls_context(address).wrap_socket(plain, server_hostname=address.host)
        except BaseException:
            plain.close()
            raise
        try:
            check_certificate(address, wrapped.getpeercert(True))
        except OSError:
            wrapped.close()
            raise
        return wrapped
    # `locate` has replaced it.
    assert not isinstance(address, MdnsAddress)
    if not isinstance(address, str):
        return _open_tcp(address, timeout_s)
    if not hasattr(socket, "AF_UNIX"):
        raise OSError("this system has no Unix sockets")
    opened = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    try:
        opened.settimeout(timeout_s)
        opened.connect(address)
    except OSError:
        opened.close()
        raise
    return opened


def _open_tcp(address: Tuple[str, int], timeout_s: float) -> socket.socket:
    """Of all addresses of that name the first that answers."""
    deadline = time.monotonic() + timeout_s
    failure = OSError("its name has no address")
    found = socket.getaddrinfo(*address, type=socket.SOCK_STREAM)
    for number, (family, kind, protocol, _, place) in enumerate(found):
        opened = None
        try:
            # Fails for a family that the kernel does not have.
            opened = socket.socket(family, kind, protocol)
            opened.settimeout(share_of(deadline, len(found) - number))
            opened.connect(place)
            opened.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            return opened
        except OSError as error:
            if opened is not None:
                opened.close()
            failure = error
    raise failure

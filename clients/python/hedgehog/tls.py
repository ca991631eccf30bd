# SPDX-License-Identifier: MIT
"""TLS 1.3 to a daemon whose certificate is known by its fingerprint, or by the authorities that the system trusts."""

import hashlib
import hmac
import ssl
from typing import Optional

from .address import TlsAddress


def tls_context(address: TlsAddress) -> ssl.SSLContext:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.minimum_version = ssl.TLSVersion.TLSv1_3
    if address.fingerprint:
        # `check_certificate` says more than any authority, and reading all of them takes 0.1 s.
        context.check_hostname = False
        context.verify_mode = ssl.CERT_NONE
    else:
        context.load_default_certs()
    return context


def check_certificate(address: TlsAddress, certificate: Optional[bytes]) -> None:
    """After the handshake, before anything is sent. Raises OSError when this is not the daemon that is meant."""
    if not address.fingerprint:
        return
    digest = hashlib.sha256(certificate or b"").digest()
    if not hmac.compare_digest(digest, address.fingerprint):
        raise OSError("its certificate has another fingerprint: " + digest.hex())

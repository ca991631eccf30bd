# SPDX-License-Identifier: MIT
"""How long to wait before the next attempt to connect: 0.1, 0.2, 0.4 ... 5 s."""

import time
from typing import List

from .address import Address, describe
from .errors import NotConnected

FIRST_S = 0.1
MAX_S = 5.0


class Backoff:
    def __init__(self) -> None:
        self._wait_s = 0.0
        self._next_s = 0.0

    def remaining_s(self, now_s: float) -> float:
        return max(0.0, self._next_s - now_s)

    def failed(self, now_s: float, at_least_s: float = 0.0) -> None:
        """at_least_s: the daemon wants no connection earlier."""
        self._wait_s = min(MAX_S, 2.0 * self._wait_s) if self._wait_s else FIRST_S
        self._next_s = now_s + max(self._wait_s, at_least_s)

    def succeeded(self) -> None:
        self._wait_s = 0.0
        self._next_s = 0.0


def share_of(deadline: float, attempts: int = 1) -> float:
    """The time until `deadline` for one of so many attempts that are left, in seconds: one that nobody answers leaves some to the
    next. More than 0, as a socket's timeout has to be."""
    return max(0.001, (deadline - time.monotonic()) / attempts)


def nobody_there(tried: List[Address], why: List[str], retry_after_s: float) -> NotConnected:
    places = "; ".join("%s: %s" % (describe(place), reason) for place, reason in zip(tried, why))
    return NotConnected("the daemon does not run: %s" % places, retry_after_s)

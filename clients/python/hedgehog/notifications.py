# SPDX-License-Identifier: MIT
"""Notifications that nobody has fetched."""

from collections import deque
from typing import Any, Deque, Dict, Mapping, Optional, Tuple

#: Of each kind; the oldest are dropped.
MAX_WAITING = 10_000
#: Those of a method that this version does not know are one kind together.
KINDS = ("event", "telemetry", "")


class Notifications:
    """In the order in which they came. Each kind has a queue of its own: a program may read one and not the other."""

    def __init__(self) -> None:
        self._last = 0
        self._queues: Dict[str, Deque[Tuple[int, str, Mapping[str, Any]]]] = {kind: deque(maxlen=MAX_WAITING) for kind in KINDS}

    def add(self, method: str, params: Mapping[str, Any]) -> None:
        self._last += 1
        self._queues[method if method in KINDS else ""].append((self._last, method, params))

    def take(self, method: str = "") -> Optional[Tuple[str, Mapping[str, Any]]]:
        """The oldest of that method, "": of all; None: there is none."""
        queues = [self._queues[method]] if method else list(self._queues.values())
        queue = min((one for one in queues if one), key=lambda one: one[0][0], default=None)
        return queue.popleft()[1:] if queue else None

# SPDX-License-Identifier: MIT
"""What a program subscribed to, for the next connection."""

from typing import Any, Dict, Iterator, Mapping

from .exchange import Exchange

BEGIN, END = ".subscribe", ".unsubscribe"


class Subscriptions:
    """By method: the daemon keeps one of each kind for a connection."""

    def __init__(self) -> None:
        self._params: Dict[str, Mapping[str, Any]] = {}

    def note(self, method: str, params: Mapping[str, Any]) -> None:
        """A request that was carried out."""
        if method.endswith(BEGIN):
            self._params[method] = params
        elif method.endswith(END):
            self._params.pop(method[:-len(END)] + BEGIN, None)

    def requests(self, exchange: Exchange) -> Iterator[bytes]:
        """What renews them on that connection. Nobody waits for the responses."""
        for method, params in self._params.items():
            request, line = exchange.request(method, params)
            exchange.forget(request)
            yield line

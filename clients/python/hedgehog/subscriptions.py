# SPDX-License-Identifier: MIT
"""What a program subscribed to, for the next connection."""

from typing import Any, Dict, Iterator, Mapping, NamedTuple, Optional

from .errors import RequestError, SubscriptionEnded
from .exchange import Exchange

BEGIN, END = "subscribe", "unsubscribe"


class Change(NamedTuple):
    """A request that was sent, and its place among all."""

    order: int
    method: str
    params: Mapping[str, Any]

    @property
    def kind(self) -> str:
        return self.method.rpartition(".")[0]

    @property
    def verb(self) -> str:
        return self.method.rpartition(".")[2]


class Subscriptions:
    """The daemon keeps one subscription of each kind for a connection: of several requests of a kind the one that was sent last
    holds, in whichever order their responses come."""

    def __init__(self) -> None:
        self._last_order = 0
        self._newest: Dict[str, Change] = {}
        self._ended: Dict[str, SubscriptionEnded] = {}
        self._renewals: Dict[int, Change] = {}

    def sent(self, method: str, params: Mapping[str, Any]) -> Change:
        """A request that is sent now, for `carried_out`."""
        self._last_order += 1
        return Change(self._last_order, method, params)

    def carried_out(self, change: Change) -> None:
        """The daemon has accepted it, or will not answer it."""
        if change.verb not in (BEGIN, END):
            return
        known = self._newest.get(change.kind)
        if known is None or known.order < change.order:
            self._newest[change.kind] = change
            self._ended.pop(change.kind, None)

    def renew(self, exchange: Exchange) -> Iterator[bytes]:
        """What makes them again on that connection; `answered` takes the responses."""
        self._renewals.clear()
        for change in self._newest.values():
            if change.verb == BEGIN:
                request, line = exchange.request(change.method, change.params)
                self._renewals[request] = change
                yield line

    def answered(self, request: int, exchange: Exchange) -> Optional[SubscriptionEnded]:
        """A response has come: the subscription that has ended by it, as the daemon refused to renew it."""
        renewal = self._renewals.pop(request, None)
        if renewal is None:
            return None
        try:
            exchange.take_response(request)
        except RequestError as refusal:
            # The program may have ended or replaced it meanwhile.
            if self._newest.get(renewal.kind) is renewal:
                self._newest[renewal.kind] = renewal._replace(method="%s.%s" % (renewal.kind, END))
                self._ended[renewal.kind] = SubscriptionEnded(renewal.method, refusal)
                return self._ended[renewal.kind]
        return None

    def ended(self, kind: str) -> Optional[SubscriptionEnded]:
        """Why there is none of this kind any more, if the daemon has refused to renew it."""
        return self._ended.get(kind)

# SPDX-License-Identifier: MIT
"""What can go wrong, each with a sentence for people."""

from typing import Any, Mapping, Optional, cast

from .messages import ErrorData


class BallError(Exception):
    """Any of the below."""


class AddressError(BallError):
    """$HEDGEHOG_ADDRESS, or the address that was given, is none."""


class NotConnected(BallError):
    """No daemon answers, or the connection has ended. The next call tries again.

    retry_after_s: until then no other attempt is made.
    """

    def __init__(self, message: str, retry_after_s: float = 0.0) -> None:
        super().__init__(message)
        self.retry_after_s = retry_after_s


class RequestError(BallError):
    """The daemon refused a request.

    code: of JSON-RPC or of the protocol: one of ErrorCode, for example ErrorCode.INVALID_PARAMS, or one of a later daemon.
    name: "invalid_params"; "" when the daemon gave none. data: field, limit, value.
    """

    def __init__(self, code: int, message: str, data: Optional[Mapping[str, Any]] = None) -> None:
        super().__init__(message)
        self.code = code
        self.data = cast(ErrorData, dict(data or {}))
        self.name = str(self.data.get("name", ""))


class SubscriptionEnded(RequestError):
    """The daemon refused to renew a subscription on a new connection; it has ended.

    method: "events.subscribe". The message begins with it.
    """

    def __init__(self, method: str, refusal: RequestError) -> None:
        super().__init__(refusal.code, "%s: %s" % (method, refusal), cast(Mapping[str, Any], refusal.data))
        self.method = method

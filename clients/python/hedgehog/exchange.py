# SPDX-License-Identifier: MIT
"""The protocol without a socket: requests to bytes, bytes to responses and notifications."""

import json
from typing import Any, Dict, List, Mapping, Optional, Set, Tuple

from .errors import RequestError
from .notifications import Notifications

#: The longest line that a daemon sends is the response to a batch; these clients send none.
MAX_LINE = 4 << 20
#: The longest wait until the next connection that a daemon can ask for.
MAX_RETRY_AFTER_S = 60.0


class Exchange:
    """One connection's messages. Not for several threads at once."""

    def __init__(self) -> None:
        self._last_id = 0
        self._partial = bytearray()
        self._responses: Dict[int, Mapping[str, Any]] = {}
        self._expected: Set[int] = set()
        self._notice: Mapping[str, Any] = {}
        self.notifications = Notifications()

    def notification(self, method: str, params: Mapping[str, Any]) -> bytes:
        return self._line({"jsonrpc": "2.0", "method": method}, params)

    def request(self, method: str, params: Mapping[str, Any]) -> Tuple[int, bytes]:
        self._last_id += 1
        # Raises ValueError for a number that JSON does not have; then nothing is expected.
        line = self._line({"jsonrpc": "2.0", "id": self._last_id, "method": method}, params)
        self._expected.add(self._last_id)
        return self._last_id, line

    def forget(self, request: int) -> None:
        """Nobody waits for this response any more."""
        self._expected.discard(request)
        self._responses.pop(request, None)

    def receive(self, data: bytes) -> List[int]:
        """Ids of the responses that came with it. Raises ValueError when what came is no JSON-RPC."""
        self._partial += data
        *lines, rest = self._partial.split(b"\n")
        self._partial = bytearray(rest)
        if len(self._partial) > MAX_LINE:
            raise ValueError("a line of more than %d bytes" % MAX_LINE)
        arrived: List[int] = []
        for line in lines:
            if line.strip():
                self._sort(json.loads(line.decode("utf-8")), arrived)
        return arrived

    def reason_of_end(self, otherwise: str) -> Tuple[str, float]:
        """Why the daemon has closed the connection: the error that it sent last and that answers no request, else `otherwise`;
        and how long it wants no other connection, in seconds."""
        data = self._notice.get("data")
        retry_after_ms = data.get("retry_after_ms") if isinstance(data, dict) else None
        retry_after_s = retry_after_ms / 1000.0 if isinstance(retry_after_ms, (int, float)) else 0.0
        return str(self._notice.get("message") or otherwise), min(MAX_RETRY_AFTER_S, retry_after_s)

    def take_response(self, request: int) -> Optional[Any]:
        """The response: its result in a list of one; None: not yet. Raises RequestError."""
        response = self._responses.pop(request, None)
        if response is None:
            return None
        self._expected.discard(request)
        error = response.get("error")
        if error is not None:
            raise RequestError(int(error.get("code", 0)), str(error.get("message", "")), error.get("data"))
        return [response.get("result")]

    def _sort(self, message: Any, arrived: List[int]) -> None:
        if not isinstance(message, dict):
            raise ValueError("a message that is no object")
        error = message.get("error")
        self._notice = error if message.get("id") is None and isinstance(error, dict) else {}
        if "method" in message:
            self.notifications.add(str(message["method"]), message.get("params", {}))
        elif message.get("id") in self._expected:
            self._responses[message["id"]] = message
            arrived.append(message["id"])

    @staticmethod
    def _line(message: Dict[str, Any], params: Mapping[str, Any]) -> bytes:
        given = {name: value for name, value in params.items() if value is not None}
        if given:
            message["params"] = given
        return json.dumps(message, separators=(",", ":"), allow_nan=False).encode("utf-8") + b"\n"

# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
"""Errors of the daemon, by name."""

import enum
from typing import Literal

ErrorName = Literal["parse_error", "invalid_request", "method_not_found", "invalid_params", "internal_error",
                    "not_armed", "busy", "no_such_effect", "unauthorized", "forbidden", "device_absent",
                    "unsupported", "refused_thermal", "no_such_pattern", "claimed", "armed"]


class ErrorCode(enum.IntEnum):
    """Codes of RequestError."""

    #: The line is not JSON.
    PARSE_ERROR = -32700
    #: JSON, but no request.
    INVALID_REQUEST = -32600
    #: There is no such method.
    METHOD_NOT_FOUND = -32601
    #: A parameter is unknown, missing, of the wrong type, out of range, or at odds with another.
    INVALID_PARAMS = -32602
    #: A bug; or the request was applied, but not written to disk.
    INTERNAL_ERROR = -32603
    #: Nothing can be played: state, reason and remedy say why.
    NOT_ARMED = -32000
    #: A queue or pool is full, or the daemon is stopping; nothing was changed.
    BUSY = -32001
    #: The effect has ended, or belongs to another connection.
    NO_SUCH_EFFECT = -32002
    #: The token is unknown or revoked.
    UNAUTHORIZED = -32003
    #: It needs role_needed.
    FORBIDDEN = -32004
    #: There is no board, or no orientation sensor.
    DEVICE_ABSENT = -32005
    #: Not by this server, not in this configuration.
    UNSUPPORTED = -32006
    #: The thermal limit would reduce the effect, and if_limited is refuse.
    REFUSED_THERMAL = -32007
    #: There is no pattern of that name.
    NO_SUCH_PATTERN = -32008
    #: Another client has exclusive use of the ball, or sets its orientation.
    CLAIMED = -32009
    #: It is refused while the ball is armed.
    ARMED = -32010

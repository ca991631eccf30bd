# SPDX-License-Identifier: MIT
"""The haptic ball Hedgehog: a client of its daemon, hedgehogd.

    from hedgehog import Ball

    with Ball() as ball:
        ball.pulse("left", level=0.5, on_close="finish")
        print(ball.status()["temperature_c"])

An effect ends with its connection unless it has `on_close="finish"`. `Ball` blocks, never longer than its timeout; `AsyncBall` is the same for asyncio.
"""

from .aio import AsyncBall
from .ball import Ball
from .discovery import discover
from .error_codes import ErrorCode, ErrorName
from .errors import AddressError, BallError, NotConnected, RequestError, SubscriptionEnded
from .mdns import DiscoveredBall
from .messages import Direction, Event, EventType, Status, Telemetry, TelemetryField

__all__ = ["AddressError", "AsyncBall", "Ball", "BallError", "Direction", "DiscoveredBall", "ErrorCode", "ErrorName", "Event", "EventType",
           "NotConnected", "RequestError", "Status", "SubscriptionEnded", "Telemetry", "TelemetryField",
           "discover"]
__version__ = "0.1.0"

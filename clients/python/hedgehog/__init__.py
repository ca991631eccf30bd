# SPDX-License-Identifier: MIT
"""The haptic ball Hedgehog: a client of its daemon, hedgehogd.

    from hedgehog import Ball

    with Ball() as ball:
        ball.pulse("left", level=0.5)
        print(ball.status()["temperature_c"])

`Ball` blocks, never longer than its patience; `AsyncBall` is the same for asyncio.
"""

from .aio import AsyncBall
from .ball import Ball
from .errors import AddressError, BallError, NotConnected, RequestError
from .methods import Direction

__all__ = ["AddressError", "AsyncBall", "Ball", "BallError", "Direction", "NotConnected", "RequestError"]
__version__ = "1.0.0"

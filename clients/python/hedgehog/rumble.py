# SPDX-License-Identifier: MIT
"""A game's 0..1 as an effect that is renewed every frame."""

from typing import Any, Dict, Mapping

from .messages import HelloLimits

#: It ends so long after the last frame: a game that hangs lets go of the ball.
LEASE_MS = 250


def felt_level(strength: float, limits: HelloLimits) -> float:
    """`strength` 0..1 as a level: 0 stays 0; anything above begins where a push can be felt (limits.felt_a)."""
    most_a = float(limits["current_a"])
    if not strength > 0.0 or not most_a > 0.0:
        return 0.0
    felt = min(1.0, float(limits["felt_a"]) / most_a)
    return felt + (1.0 - felt) * min(1.0, strength)


def rumble_params(slot: str, strength: float, limits: HelloLimits, params: Mapping[str, Any]) -> Dict[str, Any]:
    return {"slot": slot, "lease_ms": LEASE_MS, **params, "level": felt_level(strength, limits)}

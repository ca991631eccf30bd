# SPDX-License-Identifier: MIT
"""Correct code of a game, and lines that a type checker must reject: an `ignore` on a correct line is an error, too."""

from typing import List, Optional

from hedgehog import AsyncBall, Ball, Direction, ErrorCode, ErrorName, Event, NotConnected, RequestError, Telemetry, discover


def play() -> Optional[float]:
    side: Direction = [0, 1, 0]
    with Ball(name="sample", on_reconnect=lambda hello: print(hello["limits"]["felt_a"]),
              on_subscription_ended=lambda error: print(error.method, error.name == "forbidden")) as ball:
        effect: int = ball.pulse(side, level=0.5, on_close="finish")["effect"]
        ball.circle("up", duration_ms=1500, sense="cw")
        ball.play("heartbeat", loop=True, lease_ms=2000, rotate_to={"azimuth_deg": 90})
        ball.pattern_put("game/hit", keyframes=[{"t_ms": 0, "level": 1.0, "direction": {"pin": 34}}, {"t_ms": 80, "level": 0.0}])
        felt: bool = ball.rumble("engine", 0.3, "back", frequency_hz=70)
        print(effect, felt)
        for event in ball.events(["effect_ended", "state_changed"], scope="all"):
            explain_event(event)
        return ball.status()["temperature_c"]["model"]


async def follow(ball: AsyncBall) -> None:
    async for status in ball.telemetry(10, ["temperature_c"]):
        show(status)
    effects = (await ball.status())["effects"]
    print([one["slot"] for one in effects])


def find() -> List[str]:
    return ["%s at %s:%d" % (ball.name, ball.address, ball.port) for ball in discover(timeout_s=0.5) if ball.tls]


def show(status: Telemetry) -> None:
    print(status["temperature_c"]["skin"])


def explain_event(event: Event) -> str:
    return event.get("reason") or event["type"]


def explain(error: Exception) -> str:
    if isinstance(error, NotConnected):
        return "again in %g s" % error.retry_after_s
    if not isinstance(error, RequestError):
        raise error
    name: ErrorName = "refused_thermal"
    if error.code == ErrorCode.INVALID_PARAMS:
        return "%s: %s" % (error.data.get("field"), error)
    return "too warm" if error.name == name else str(error)


def type_errors(ball: Ball) -> None:
    discover(timeout_s="1 s")  # type: ignore[arg-type]
    ball.pulse("sideways")  # type: ignore[arg-type]
    ball.pulse("left", level="0.5")  # type: ignore[arg-type]
    ball.pulse("left", leval=0.5)  # type: ignore[call-arg]
    ball.vibrate("down", waveform="sinus")  # type: ignore[arg-type]
    ball.hold()  # type: ignore[call-arg]
    ball.status()["temperature"]  # type: ignore[typeddict-item]
    ball.status()["temperature_c"]["model"] + 1.0  # type: ignore[operator]
    ball.events(["effect_over"])  # type: ignore[list-item]
    ball.telemetry(10, ["temperatur_c"])  # type: ignore[list-item]
    ErrorCode.TOO_WARM  # type: ignore[attr-defined]

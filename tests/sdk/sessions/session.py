# SPDX-License-Identifier: MIT
"""session.py ADDRESS: every method of the protocol once, as a program in Python calls it."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "clients" / "python"))

import hedgehog  # noqa: E402

TIMEOUT_S = 60.0
KNOCK = [{"t_ms": 0, "direction": "front", "level": 1}, {"t_ms": 60, "level": 0}, {"t_ms": 120, "level": 0.6}, {"t_ms": 180, "level": 0}]


def refusal(call, *args, **params):
    try:
        call(*args, **params)
    except hedgehog.RequestError as error:
        return error.name
    raise SystemExit("session.py: %s was not refused" % call.__name__)


def skip_to(events, kind):
    """What starts or ends is waited for, so that the order of the session's lines is always the same."""
    return next(event for event in events if event["type"] == kind)


def query(ball):
    ball.ping()
    ball.describe()
    ball.status()
    ball.list()
    ball.connection_list()


def play(ball, events):
    ball.pulse("left", level=0.6, duration_ms=60)
    skip_to(events, "effect_ended")
    ball.vibrate([0, 1, 0.5], frequency_hz=40, slot="engine", lease_ms=10_000)
    skip_to(events, "effect_started")
    ball.update(slot="engine", level=0.3)
    ball.stop(slot="engine")
    skip_to(events, "effect_ended")
    ball.hold({"azimuth_deg": 90, "elevation_deg": 20}, current_a=4, duration_ms=80, priority=7)
    skip_to(events, "effect_ended")
    turn = ball.circle("up", speed_pins_s=20, sense="cw", duration_ms=10_000)
    skip_to(events, "effect_started")
    ball.stop(effect=turn["effect"])
    skip_to(events, "effect_ended")
    ball.rumble("road", 0.4, "down", frequency_hz=60, lease_ms=10_000)
    skip_to(events, "effect_started")
    ball.rumble("road", 0)
    skip_to(events, "effect_ended")
    ball.hold({"pin": 34}, lease_ms=10_000)
    skip_to(events, "effect_started")
    ball.stop_all()
    skip_to(events, "effect_ended")


def manage_patterns(ball, events):
    ball.pattern_put("acme/knock", KNOCK, description="Two knocks.")
    ball.pattern_list()
    ball.pattern_get("acme/knock")
    ball.play("acme/knock", rotate_to="right")
    skip_to(events, "effect_ended")
    ball.play(keyframes=KNOCK, rate=2)
    skip_to(events, "effect_ended")
    ball.pattern_remove("acme/knock")


def forecast_effects(ball):
    ball.preview("effect.pulse", {"direction": "up", "duration_ms": 20})
    ball.thermal_forecast(current_a=12, direction="left")
    ball.latency()


def watch(ball):
    next(ball.telemetry(20, ["state", "temperature_c", "current_a", "orientation"], timeout_s=TIMEOUT_S))
    ball.call("telemetry.unsubscribe")
    ball.telemetry_history(seconds=10)
    ball.events_history(limit=3)


def operate(ball, events):
    ball.claim(lease_ms=2000)
    ball.release()
    ball.output_set_gain(0.8)
    ball.output_set_gain(1)
    ball.orientation_recenter(azimuth_deg=-40)
    assert refusal(ball.orientation_set, {"w": 1, "x": 0, "y": 0, "z": 0}) == "unsupported"
    ball.sim_set(ambient_c=24, fault={})
    ball.sim_truth()
    assert refusal(ball.enter_boot_loader) == "armed"
    ball.emergency_stop()
    skip_to(events, "state_changed")
    assert refusal(ball.pulse, "left") == "not_armed"
    ball.arm()
    skip_to(events, "state_changed")


def provoke_errors(ball):
    assert refusal(ball.pulse, "sideways") == "invalid_params"
    assert refusal(ball.call, "effect.rattle", direction="left") == "method_not_found"
    assert refusal(ball.stop, slot="nothing") == "no_such_effect"
    assert refusal(ball.play, "hartbeat") == "no_such_pattern"


def main(address):
    with hedgehog.Ball(address, name="session/python", timeout_s=TIMEOUT_S) as ball:
        query(ball)
        events = ball.events(["effect_started", "effect_ended", "state_changed"], timeout_s=TIMEOUT_S)
        play(ball, events)
        manage_patterns(ball, events)
        forecast_effects(ball)
        watch(ball)
        operate(ball, events)
        provoke_errors(ball)
        ball.call("events.unsubscribe")


if __name__ == "__main__":
    main(sys.argv[1])

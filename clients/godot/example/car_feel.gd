# SPDX-License-Identifier: MIT
# What happens to a car, felt on the ball: the haptics of hedgehog-racer (clients/racer/feel) for a game of your own. Directions are
# in the car's frame: x right, y up, -z forward.
extends Node

const Ball = preload("res://addons/hedgehog/ball.gd")

# People notice a change of force of 13 % (thesis, experiment 2). Eight steps from what is just felt to full strength, in equal
# ratios, are 32 % apart. A blow of these impulses, in Newton seconds, is the first and the last step.
const STEPS := 8
const SOFTEST_BLOW := 150.0
const HARDEST_BLOW := 8000.0
# One blow in so many seconds, unless a harder one comes.
const APART_S := 0.25
# A blow is felt alone; the skid wins over the engine.
const BLOW := 7
const SKID := 5
const ENGINE := 3

var ball = Ball.new()
var time_s := 0.0
var last_step := -1
var last_blow_s := 0.0


func _ready() -> void:
	ball.client_name = "car"
	add_child(ball)


func _process(delta) -> void:
	time_s += delta


# Every frame. `revolutions` and `throttle`: 0..1.
func engine(revolutions: float, throttle: float) -> void:
	var frequency_hz = 30.0 + 60.0 * revolutions
	ball.rumble("engine", 0.05 + 0.25 * throttle, "back", {"frequency_hz": frequency_hz, "priority": ENGINE})


# Every frame in which the wheels slide. `amount`: 0 grips .. 1 no grip at all. It lasts, so it is weaker than a blow can be.
func skid(amount: float) -> void:
	ball.rumble("skid", 0.5 * amount, "down", {"waveform": "square", "frequency_hz": 60, "priority": SKID})


# Once for each blow: where on the car, and how hard, in Newton seconds.
func hit(direction: Vector3, impulse_n_s: float) -> void:
	blow(direction, impulse_n_s, 180)


# The wheels are back on the ground.
func landing(impulse_n_s: float) -> void:
	blow(Vector3(0, -1, 0), impulse_n_s, 140)


# The pause menu: everything ends; the next frame may play again.
func pause() -> void:
	ball.notify("effect.stop_all")


func blow(direction: Vector3, impulse_n_s: float, duration_ms: int) -> void:
	var step = step_of(impulse_n_s)
	if not ball.is_open() or (time_s - last_blow_s < APART_S and step <= last_step):
		return
	last_step = step
	last_blow_s = time_s
	ball.notify("effect.pulse", {"direction": direction, "current_a": strength_of(step), "duration_ms": duration_ms, "priority": BLOW})


func step_of(impulse_n_s: float) -> int:
	var share = log(max(impulse_n_s, SOFTEST_BLOW) / SOFTEST_BLOW) / log(HARDEST_BLOW / SOFTEST_BLOW)
	return int(round((STEPS - 1) * min(share, 1.0)))


# In ampere, of this ball.
func strength_of(step: int) -> float:
	var felt_a = ball.hello.limits.felt_a
	var full_a = max(felt_a, ball.hello.limits.current_a)
	return min(full_a, felt_a * pow(full_a / felt_a, float(step) / (STEPS - 1)))

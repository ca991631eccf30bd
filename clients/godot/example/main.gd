# SPDX-License-Identifier: MIT
# A lap without a picture, to feel: the car pulls away, slides through a bend, hits the wall on its left and lands after a jump.
extends Node

const CarFeel = preload("res://car_feel.gd")
const SKID_S := [1.5, 2.5]
const LAP_S := 5.0
# When, what, and its arguments.
const HAPPENINGS := [[3.0, "hit", [Vector3(-1, 0, 0), 2400.0]], [4.0, "landing", [900.0]]]

var car = CarFeel.new()
var time_s := 0.0
var happened := 0


func _ready() -> void:
	add_child(car)


func _process(delta) -> void:
	# The lap begins when the ball is there.
	if not car.ball.is_open():
		return
	time_s += delta
	car.engine(min(1.0, time_s / LAP_S), 1.0 if time_s < SKID_S[0] else 0.5)
	if time_s > SKID_S[0] and time_s < SKID_S[1]:
		car.skid((time_s - SKID_S[0]) / (SKID_S[1] - SKID_S[0]))
	while happened < HAPPENINGS.size() and time_s >= HAPPENINGS[happened][0]:
		print("%s at %s s" % [HAPPENINGS[happened][1], HAPPENINGS[happened][0]])
		car.callv(HAPPENINGS[happened][1], HAPPENINGS[happened][2])
		happened += 1
	if time_s > LAP_S:
		get_tree().quit()

# SPDX-License-Identifier: MIT
# A ball that keeps its notifications: signals are connected in other ways in Godot 3 and 4.
extends "res://addons/hedgehog/ball.gd"

var received := []


func on_notification(method: String, params: Dictionary) -> void:
	received.append([method, params])

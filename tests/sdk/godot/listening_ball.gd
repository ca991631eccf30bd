# SPDX-License-Identifier: MIT
# A ball that keeps its notifications and ended subscriptions, and counts its connections: signals are connected in other ways in Godot 3 and 4.
extends "res://addons/hedgehog/ball.gd"

var received := []
var connections := 0
var ended := []
# A method that is asked for when a subscription has ended, and its request.
var asked_when_ended := ""
var waiting = null


func on_notification(method: String, params: Dictionary) -> void:
	received.append([method, params])


func on_connected() -> void:
	connections += 1


func on_subscription_ended(answer) -> void:
	ended.append("%s: %s" % [answer.method, answer.message])
	if asked_when_ended != "":
		waiting = request(asked_when_ended)

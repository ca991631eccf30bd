# SPDX-License-Identifier: MIT
# The addon against a simulated daemon. ANSWER(x) and CONNECT(signal, function) are written as the Godot that runs it does.
extends Node

const Ball = preload("res://addons/hedgehog/ball.gd")
const Address = preload("res://addons/hedgehog/address.gd")

var ball = Ball.new()
var statuses := 0
var frames := 0


func _ready():
	ball.timeout_s = 60.0
	add_child(ball)
	CONNECT(connected, _on_connected)
	CONNECT(disconnected, _on_disconnected)
	CONNECT(event_received, _on_event)
	CONNECT(telemetry_received, _on_status)
	call(OS.get_environment("HEDGEHOG_SCENE"))


func _process(_delta):
	frames += 1
	if frames == 30:
		print("30 frames, connected ", ball.is_open())


func effects():
	ball.events(["effect_ended"])
	var status = ANSWER(ball.status())
	print("state ", status.result.state)
	var temperature = status.result[Ball.Fields.Status.TEMPERATURE_C][Ball.Fields.StatusTemperatureC.MODEL]
	print("fields ", temperature > 10 and status.result[Ball.Fields.Status.LOOP][Ball.Fields.StatusLoop.RATE_HZ] > 100)
	var left = ANSWER(ball.pulse("left", {"level": 0.5, "duration_ms": 30}))
	var towards = ANSWER(ball.pulse(Vector3(-1, 0, 0), {"level": 0.5, "duration_ms": 30}))
	print("same pin ", left.result.pin == towards.result.pin)
	var held = ANSWER(ball.hold("up", {"lease_ms": 10000}))
	var stopped = ANSWER(ball.stop({"effect": held.result.effect}))
	print("stopped ", stopped.result.stopped)
	var refused = ANSWER(ball.pulse("left", {"level": 1.4}))
	print("refused ", refused.failure, " ", refused.error_name, " ", refused.data.field)
	print("its code ", ball.ERROR_CODES.invalid_params == refused.code)
	var infinite = ANSWER(ball.play(null, {"keyframes": [{"level": 1e308 * 10}]}))
	print("infinite ", infinite.message)
	ball.notify("effect.pulse", {"direction": "left", "strenght": 1})
	ball.notify("effect.pulse", {"direction": "left", "level": 1.4})
	ball.notify("effect.pulse", {"direction": "left", "waveform": "sinus"})
	ball.telemetry(100, ["limit_a"])


func outage():
	ball.events(["effect_ended"])


func missing_daemon():
	var failed = ANSWER(ball.ping())
	print(failed.failure, " ", failed.message)
	var retried = ANSWER(ball.ping())
	print("again ", retried.failure, " ", retried.message)
	ball.close()
	var closed = ANSWER(ball.ping())
	print(closed.message)
	get_tree().quit()


func slow_name():
	# Until it is ended.
	pass


func addresses():
	for text in ["game-pc", "::1", "[::1]:9", "tcp:127.0.0.1:7", "host:x", "host:0", "[::1", "unix:", ":7", "host:70000", "host:", "/run/x", "tls://ball-host", "mdns://ball-7"]:
		var address = Address.parse(text)
		print(text, " ", address.error if address.has("error") else Address.describe(address))
	get_tree().quit()


func _on_connected(hello):
	print("connected ", hello.role)
	if OS.get_environment("HEDGEHOG_SCENE") == "outage":
		ball.pulse("left", {"duration_ms": 30})


func _on_disconnected(reason):
	print("disconnected ", reason)


func _on_event(event):
	print("event ", event[Ball.Fields.Event.TYPE], " ", event[Ball.Fields.Event.REASON])


func _on_status(status):
	statuses += 1
	if statuses == 3:
		print("telemetry with limit_a ", status.has("limit_a"))
		get_tree().quit()

# SPDX-License-Identifier: MIT
# Drives the addon through the case of conformance.json in HEDGEHOG_CASE, for Godot 3 and 4. Prints "passed", or what differs.
extends Node

const ListeningBall = preload("res://listening_ball.gd")

var ball = ListeningBall.new()
var steps := []
var at := 0
var asked = null
var again_s := 0.0
# When the step began.
var began_s := 0.0


func _ready():
	steps = ball._engine.from_text(OS.get_environment("HEDGEHOG_CASE")).client
	ball.client_name = "conformance"
	ball.timeout_s = float(OS.get_environment("HEDGEHOG_TIMEOUT_S"))
	add_child(ball)
	# A case without an opening begins with the connection.
	if not steps[0].has("open"):
		asked = ball.open()
		at = -1


func _process(_delta):
	if at < 0:
		if asked.done:
			check(asked.ok, asked.message)
			next()
	elif at < steps.size():
		take(steps[at])
	else:
		ball.close()
		print("passed")
		get_tree().quit(0)


func take(step):
	if step.has("notification"):
		if ball.received.size() > 0:
			check(same(ball.received.pop_front(), [step.notification, step.get("params", {})]), "another notification")
			next()
	elif step.has("reconnected"):
		check(ball.connections - 1 == step.reconnected, "%d connections" % ball.connections)
		next()
	elif step.has("ask"):
		ball.waiting = ball.request(step.ask)
		next()
	elif step.has("ask_when_ended"):
		ball.asked_when_ended = step.ask_when_ended
		next()
	elif step.has("answered"):
		if ball.waiting != null and ball.waiting.done:
			asked = ball.waiting
			answer(step)
	elif step.has("flood"):
		flood(step.flood)
		next()
	elif step.has("rumble_again"):
		if ball.rumble(step.rumble_again, step.strength):
			next()
	elif step.has("subscriptions_ended"):
		check(same(ball.ended, step.subscriptions_ended), "ended are %s" % [ball.ended])
		next()
	elif step.has("notify"):
		check(ball.notify(step.notify, step.get("params", {})), "not sent")
		next()
	elif step.has("rumble"):
		check(ball.rumble(step.rumble, step.strength, step.get("direction"), step.get("params", {})), "not sent")
		next()
	elif asked == null:
		if ball._engine.now_s() >= again_s:
			asked = ball.open() if step.has("open") else ball.request(method_of(step), params_of(step))
	elif asked.done:
		answer(step)


func answer(step):
	if step.has("call_again") and not asked.ok:
		check(asked.failure == "not_connected", asked.message)
		again_s = ball._engine.now_s() + asked.retry_after_s
		asked = null
		return
	if step.has("not_finite"):
		check(asked.failure == "bad_value", "failure is " + asked.failure)
	elif step.has("failure"):
		check(asked.failure == step.failure, "failure is " + asked.failure)
		check(step.says in asked.message, asked.message)
		if step.has("retry_s"):
			check(asked.retry_after_s >= step.retry_s[0] and asked.retry_after_s <= step.retry_s[1], "%s s" % asked.retry_after_s)
	elif step.has("error"):
		check(asked.failure == "refused", "failure is " + asked.failure)
		check(same([asked.code, asked.error_name, asked.message, asked.data.get("field")],
			[step.error.code, step.error.name, step.error.message, step.error.get("field")]), asked.message)
	else:
		check(asked.ok, asked.message)
		check(not step.has("result") or same(asked.result, step.get("result")), "another result")
	next()


# Far more than what the kernel and the addon keep, in lines shorter than 64 KiB.
func flood(method):
	var text = "x"
	for _doubled in range(15):
		text += text
	for _line in range(2000):
		if not ball.notify(method, {"text": text}):
			return
	check(false, "what the daemon does not read is kept")


func next():
	if at >= 0 and at < steps.size():
		check(ball._engine.now_s() - began_s >= steps[at].get("at_least_s", 0.0), "too early")
	began_s = ball._engine.now_s()
	asked = null
	at += 1


func params_of(step):
	var params = step.get("params", {}).duplicate()
	if step.has("not_finite"):
		params[step.not_finite] = NAN
	return params


func method_of(step):
	return step.call if step.has("call") else step.call_again


# Godot 3 compares dictionaries by identity.
func same(a, b):
	if a is Dictionary and b is Dictionary:
		for key in a:
			if not b.has(key) or not same(a[key], b[key]):
				return false
		return a.size() == b.size()
	if a is Array and b is Array:
		for i in range(min(a.size(), b.size())):
			if not same(a[i], b[i]):
				return false
		return a.size() == b.size()
	return a == b if (a == null) == (b == null) else false


func check(holds, otherwise):
	if not holds:
		print("step %d: %s" % [at, otherwise])
		at = steps.size() + 1
		get_tree().quit(1)
		set_process(false)

# SPDX-License-Identifier: MIT
# The ball as a node: a connection to hedgehogd, the daemon of the haptic ball Hedgehog. Runs in Godot 3.2 and later and in Godot 4.
#
#   const Ball = preload("res://addons/hedgehog/ball.gd")
#   var ball = Ball.new()
#   add_child(ball)
#   ball.pulse("left", {"level": 0.5})
#   ball.rumble("engine", 0.3, "back", {"frequency_hz": 70})      # every frame
#
# Nothing waits: every method of the protocol (methods.gd) returns a request (request.gd) that emits `completed`. While the node is
# in the tree it finds the daemon, and finds it again 0.1 to 5 s after it was lost. The effects of a connection end with it.
extends "res://addons/hedgehog/methods.gd"

# It can play now. `hello`: what the daemon tells of itself: server, role, limits.
signal connected(hello)
# It could, and cannot any more.
signal disconnected(reason)
# What `events` asked for.
signal event_received(event)
# What `telemetry` asked for.
signal telemetry_received(status)
# A subscription of before could not be renewed on a new connection and has ended: a request (request.gd) that was refused.
signal subscription_ended(answer)
# Any of the daemon's notifications.
signal notification_received(method, params)

const Address = preload("res://addons/hedgehog/address.gd")
const Fields = preload("res://addons/hedgehog/fields.gd")
const Request = preload("res://addons/hedgehog/request.gd")
const Resolver = preload("res://addons/hedgehog/resolver.gd")
const Session = preload("res://addons/hedgehog/session.gd")
const Subscriptions = preload("res://addons/hedgehog/subscriptions.gd")
const Values = preload("res://addons/hedgehog/values.gd")

const FIRST_WAIT_S := 0.1
const MAX_WAIT_S := 5.0

# "127.0.0.1:7586"; empty: found as address.gd has it. Set before the node is in the tree, as the next three.
var address := ""
# Of this program, as the daemon's log and `hedgehogctl clients` show it.
var client_name := "godot"
# Connecting, and waiting for a response, take no longer.
var timeout_s := 2.0
# Of roles beyond those of this machine; empty: HEDGEHOG_TOKEN.
var token := ""
# What the daemon tells of itself; empty: not connected.
var hello := {}

var _engine = load("res://addons/hedgehog/engine_%d.gd" % int(min(4, Engine.get_version_info().major))).new()
var _resolver = Resolver.new(_engine)
var _session = null
var _place := {}
var _wait_s := 0.0
var _next_attempt_s := 0.0
var _closed := false
# The outage has had its line in the output.
var _reported := false
# [request, parameters] that wait for the connection.
var _queue := []
# Requests whose end is reported once the caller can wait for it.
var _later := []
var _subscriptions = Subscriptions.new()
var _warned := {}


func _ready() -> void:
	_engine.work_while_paused(self)


func _process(_delta) -> void:
	poll()


# Whether the daemon is there and knows this program.
func is_open() -> bool:
	return hello.size() > 0


# Succeeds when the daemon is there.
func open():
	return _ask_or_wait(Request.new("open"), {})


# Ends the connection, and with it its effects.
func close() -> void:
	_closed = true
	_end("this ball is closed", {})


# A request: see request.gd. Parameters that are null are left out.
func request(method: String, params: Dictionary = {}):
	var asked = Request.new(method)
	var field = Values.non_finite(params, "")
	if field != "":
		return _fail_later(asked, Request.BAD_VALUE, "%s: is no number" % field)
	var known = Values.given(params)
	_subscriptions.change(asked, method, known)
	return _ask_or_wait(asked, known)


# Sends and expects no response: for every frame of a game. false: nothing was sent, there is no daemon.
func notify(method: String, params: Dictionary = {}) -> bool:
	_warn_of(method, params)
	if not is_open() or Values.non_finite(params, "") != "":
		return false
	var known = Values.given(params)
	if not _session.send(method, known):
		return false
	_subscriptions.change(null, method, known)
	return true


# A vibration that goes on while this is called every frame; strength 0..1, 0 ends it. As `notify`.
func rumble(slot: String, strength: float, direction = null, params: Dictionary = {}) -> bool:
	if not strength > 0.0:
		return notify("effect.stop", {"slot": slot})
	if not is_open():
		return false
	var effect = {"slot": slot, "direction": direction, "lease_ms": Values.LEASE_MS}
	for key in params:
		effect[key] = params[key]
	effect["level"] = Values.felt_level(strength, hello.limits)
	return notify("effect.vibrate", effect)


# From now on `event_received` comes, after a lost connection too. `types`: an array of EVENTS, null for all; `scope`: "all" for
# effects of others too.
func events(types = null, scope = null):
	return request("events.subscribe", {"types": types, "scope": scope})


func end_events():
	return request("events.unsubscribe")


# From now on `telemetry_received` comes, after a lost connection too.
func telemetry(rate_hz: float = 10.0, fields = null):
	return request("telemetry.subscribe", {"rate_hz": rate_hz, "fields": fields})


func end_telemetry():
	return request("telemetry.unsubscribe")


# What came and what is late; `_process` does it every frame.
func poll() -> void:
	_report_later()
	if _closed:
		return
	if _session == null:
		if _remaining_s() <= 0.0:
			_connect()
		return
	var session = _session
	session.poll()
	# Whoever was called may have closed this ball.
	if session != _session:
		return
	if session.ended != "":
		_lose()
	elif session.is_open() and not is_open():
		_begin()


# For the session.
func on_notification(method: String, params: Dictionary) -> void:
	emit_signal("notification_received", method, params)
	if method == "event":
		emit_signal("event_received", params)
	elif method == "telemetry":
		emit_signal("telemetry_received", params)


# For the session, before the request is told. True: `on_subscription_ended` follows.
func on_answer(asked, accepted: bool) -> bool:
	return _subscriptions.answered(asked, accepted)


func on_subscription_ended(answer) -> void:
	emit_signal("subscription_ended", answer)


func _connect() -> void:
	_place = Address.find(address)
	if _place.has("error"):
		_back_off()
		_report_outage(_place.error)
		_fail_all([], Request.BAD_ADDRESS, _place.error)
		return
	var shown = token if token != "" else OS.get_environment("HEDGEHOG_TOKEN")
	var introduction = {"client": client_name, "protocol": "1", "token": shown if shown != "" else null}
	_session = Session.new(_engine, self, Values.given(introduction), timeout_s)
	_session.start(_resolver, _place.host, _place.port)


func _begin() -> void:
	hello = _session.hello
	_wait_s = 0.0
	_next_attempt_s = 0.0
	_reported = false
	var queued = _queue
	_queue = []
	var asked = []
	for waiting in queued:
		asked.append(waiting[0])
	for one in _subscriptions.current():
		if not one.request in asked:
			_subscriptions.renew(one, Request.new(one.method))
			_session.ask(one.request, one.params)
	for waiting in queued:
		_ask_or_wait(waiting[0], waiting[1])
	on_connected()


func on_connected() -> void:
	emit_signal("connected", hello)


# The daemon refused the introduction, is gone, or was never there.
func _lose() -> void:
	_back_off(_session.retry_after_s())
	var reason = "the connection to the daemon has ended: %s" % _session.ended
	if not _session.was_reached():
		reason = "the daemon does not run: %s: %s" % [Address.describe(_place), _session.ended]
	elif _session.refusal.size() > 0:
		reason = _session.ended
	_report_outage(reason)
	_end(reason, _session.refusal)


func _end(reason: String, refusal: Dictionary) -> void:
	var was_open = is_open()
	hello = {}
	var unanswered = _session.close(reason) if _session != null else []
	_session = null
	if refusal.size() > 0:
		for waiting in _queue:
			waiting[0].refuse(refusal)
		_queue = []
	_fail_all(unanswered, Request.NOT_CONNECTED, reason)
	if was_open:
		emit_signal("disconnected", reason)


func _fail_all(unanswered: Array, kind: String, reason: String) -> void:
	for waiting in _queue:
		unanswered.append(waiting[0])
	_queue = []
	for asked in unanswered:
		asked.fail(kind, reason, _remaining_s())


func _ask_or_wait(asked, params: Dictionary):
	if _closed:
		return _fail_later(asked, Request.NOT_CONNECTED, "this ball is closed")
	if _session == null and _remaining_s() > 0.0:
		return _fail_later(asked, Request.NOT_CONNECTED, "the daemon does not run; next attempt in %.1f s" % _remaining_s())
	if not is_open():
		_queue.append([asked, params])
	elif asked.method == "open":
		_later.append(asked)
		call_deferred("_report_later")
	else:
		_session.ask(asked, params)
	return asked


func _fail_later(asked, kind: String, reason: String):
	asked.failure = kind
	asked.message = reason
	asked.retry_after_s = _remaining_s()
	_later.append(asked)
	call_deferred("_report_later")
	return asked


func _report_later() -> void:
	var reported = _later
	_later = []
	for asked in reported:
		if asked.failure == "":
			asked.succeed(hello)
		else:
			asked.fail(asked.failure, asked.message, asked.retry_after_s)


# `at_least_s`: the daemon wants no connection earlier.
func _back_off(at_least_s: float = 0.0) -> void:
	_wait_s = min(MAX_WAIT_S, 2.0 * _wait_s) if _wait_s > 0.0 else FIRST_WAIT_S
	_next_attempt_s = _engine.now_s() + max(_wait_s, at_least_s)


func _remaining_s() -> float:
	return max(0.0, _next_attempt_s - _engine.now_s())


func _report_outage(reason: String) -> void:
	if not _reported:
		push_warning("hedgehog: " + reason)
	_reported = true


# Nobody reads the refusal of a notification: in a debug build what the daemon will refuse is told here, once.
func _warn_of(method: String, params: Dictionary) -> void:
	if not OS.is_debug_build():
		return
	var sentence = problem_of(method, params)
	if sentence != "" and not _warned.has(sentence):
		_warned[sentence] = true
		push_warning("hedgehog: %s: %s" % [method, sentence])

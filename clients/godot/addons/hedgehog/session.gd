# SPDX-License-Identifier: MIT
# One connection's conversation: the introduction, requests with their responses, notifications. Nothing here waits.

const Connection = preload("res://addons/hedgehog/connection.gd")

# The longest wait until the next connection that a daemon can ask for.
const MAX_RETRY_AFTER_S := 60.0

# What the daemon told of itself; empty: not yet.
var hello := {}
# Set once it has ended: why.
var ended := ""
# Of the introduction, an error of JSON-RPC; empty: none.
var refusal := {}
# The error that the daemon sent last, if it answers no request: why it closes the connection; empty: none.
var notice := {}

var _engine
# Is given what comes: on_notification(method, params), on_answer(request, accepted), on_subscription_ended(request).
var _listener
var _connection
var _introduction := {}
var _timeout_s := 0.0
var _deadline_s := 0.0
var _hello_id := 0
var _was_answered := false
var _last_id := 0
# By id: [request, when it is late].
var _pending := {}


func _init(engine, listener, introduction: Dictionary, timeout_s: float):
	_engine = engine
	_listener = listener
	_introduction = introduction
	_timeout_s = timeout_s


func start(resolver, host: String, port: int) -> void:
	_deadline_s = _engine.now_s() + _timeout_s
	_connection = Connection.new(_engine, resolver)
	_connection.start(host, port)


func is_open() -> bool:
	return hello.size() > 0 and ended == ""


# Whether the other side is there, as a daemon or not.
func was_reached() -> bool:
	return _hello_id > 0 or _was_answered


func ask(request, params: Dictionary) -> void:
	_last_id += 1
	_pending[_last_id] = [request, _engine.now_s() + _timeout_s]
	send(request.method, params, _last_id)


# Without `id` there is no response. false: the connection has ended.
func send(method: String, params: Dictionary, id: int = 0) -> bool:
	var message = {"jsonrpc": "2.0", "method": method}
	if id > 0:
		message["id"] = id
	if params.size() > 0:
		message["params"] = params
	return _connection.send(_engine.to_text(message))


func poll() -> void:
	for line in _connection.receive():
		_receive(line)
		# Whoever was called may have closed it.
		if ended != "":
			return
	if _connection.ended != "":
		ended = str(notice.get("message", _connection.ended))
	elif _connection.is_open() and _hello_id == 0:
		_introduce()
	else:
		_check_deadlines()


# So long the daemon wants no other connection; 0: it does not say.
func retry_after_s() -> float:
	var data = notice.get("data")
	var wait_ms = data.get("retry_after_ms") if data is Dictionary else null
	return min(MAX_RETRY_AFTER_S, float(wait_ms) / 1000.0) if wait_ms != null and str(wait_ms).is_valid_float() else 0.0


# Requests that have no answer and will get none.
func close(reason: String) -> Array:
	ended = reason
	_connection.close()
	var unanswered = []
	for id in _pending:
		unanswered.append(_pending[id][0])
	_pending = {}
	return unanswered


func _introduce() -> void:
	_last_id += 1
	_hello_id = _last_id
	_deadline_s = _engine.now_s() + _timeout_s
	send("hello", _introduction, _hello_id)


func _check_deadlines() -> void:
	var now_s = _engine.now_s()
	if hello.size() == 0 and now_s > _deadline_s:
		ended = "%sno response within %s s" % ["hello: " if was_reached() else "", _timeout_s]
	for id in _pending:
		if now_s > _pending[id][1]:
			ended = "%s: no response within %s s" % [_pending[id][0].method, _timeout_s]


func _receive(line: String) -> void:
	_was_answered = true
	var message = _engine.from_text(line)
	if not message is Dictionary:
		ended = "the server is not a Hedgehog daemon"
		return
	notice = message.error if message.get("id") == null and message.get("error") is Dictionary else {}
	if message.has("method"):
		var params = message.get("params")
		_listener.on_notification(str(message.method), params if params is Dictionary else {})
		return
	# Numbers come as floats.
	var id = message.get("id")
	id = int(id) if id != null and str(id).is_valid_float() else 0
	# A daemon without a place for another client says so before it is asked.
	if id == _hello_id and id > 0:
		_take_introduction(message)
	elif _pending.has(id):
		var request = _pending[id][0]
		_pending.erase(id)
		var accepted = not (message.get("error") is Dictionary)
		var ended = _listener.on_answer(request, accepted)
		if accepted:
			request.succeed(message.get("result"))
		else:
			request.refuse(message.error)
		if ended:
			_listener.on_subscription_ended(request)


func _take_introduction(message: Dictionary) -> void:
	if message.get("error") is Dictionary:
		refusal = message.error
		ended = str(refusal.get("message", ""))
	elif message.get("result") is Dictionary and message.result.get("limits") is Dictionary:
		hello = message.result
	else:
		ended = "the server is not a Hedgehog daemon"

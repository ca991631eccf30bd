# SPDX-License-Identifier: MIT
# A request, and its answer when that has come:
#   Godot 4: var answer = await ball.status().completed
#   Godot 3: var answer = yield(ball.status(), "completed")
#   if answer.ok: print(answer.result.temperature_c.model) else: print(answer.message)

signal completed(answer)

const REFUSED = "refused"
const NOT_CONNECTED = "not_connected"
const BAD_ADDRESS = "bad_address"
const BAD_VALUE = "bad_value"

var method := ""
var done := false
var ok := false
# What the daemon answered, a Dictionary.
var result = null

# Why it failed, one sentence for people; the rest says it for programs.
var message := ""
# REFUSED by the daemon; NOT_CONNECTED; BAD_ADDRESS: what was given as the daemon's address is none; BAD_VALUE: a number that
# JSON has not.
var failure := ""
# Of a refusal: the protocol's number and name, and data.field, data.limit, data.value.
var code := 0
var error_name := ""
var data := {}
# NOT_CONNECTED: the next attempt is so far away.
var retry_after_s := 0.0


func _init(asked_method: String):
	method = asked_method


func succeed(with_result) -> void:
	ok = true
	result = with_result
	_complete()


# `error`: of JSON-RPC.
func refuse(error: Dictionary) -> void:
	failure = REFUSED
	code = int(error.get("code", 0))
	message = str(error.get("message", ""))
	if error.get("data") is Dictionary:
		data = error.data
	error_name = str(data.get("name", ""))
	_complete()


func fail(kind: String, sentence: String, wait_s: float) -> void:
	failure = kind
	message = sentence
	retry_after_s = wait_s
	_complete()


func _complete() -> void:
	done = true
	if not ok and get_signal_connection_list("completed").size() == 0:
		push_warning("hedgehog: %s: %s" % [method, message])
	emit_signal("completed", self)

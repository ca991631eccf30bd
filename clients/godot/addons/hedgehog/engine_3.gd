# SPDX-License-Identifier: MIT
# What Godot 3 calls differently from Godot 4; engine_4.gd is its counterpart. Names that Godot 4 does not have are only looked
# up when they are used, so that its editor reads this file without complaint.

var _os: Object = OS
var _json: Object = Engine.get_singleton("JSON")


func now_s() -> float:
	return _os.get_ticks_msec() / 1000.0


# The node works on while the game is paused: what it plays and waits for goes on too.
func work_while_paused(node: Node) -> void:
	node.set("pause_mode", 2)


func to_text(value) -> String:
	return _json.print(value)


# null: this is no JSON.
func from_text(text: String):
	var parsed = _json.parse(text)
	return parsed.result if parsed.error == OK else null


func to_bytes(text):
	return text.to_utf8()


# Bytes from `begin` on, before `end`.
func part(bytes, begin: int, end: int):
	return bytes.subarray(begin, end - 1) if begin < end else to_bytes("")


func start_thread(thread, object, method: String, argument) -> int:
	return thread.start(object, method, argument)


func poll(_peer) -> void:
	pass

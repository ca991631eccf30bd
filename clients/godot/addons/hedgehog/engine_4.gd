# SPDX-License-Identifier: MIT
# What Godot 4 calls differently from Godot 3; engine_3.gd is its counterpart.


func now_s() -> float:
	return Time.get_ticks_msec() / 1000.0


# The node works on while the game is paused: what it plays and waits for goes on too.
func work_while_paused(node: Node) -> void:
	node.process_mode = Node.PROCESS_MODE_ALWAYS


func to_text(value) -> String:
	return JSON.stringify(value)


# null: this is no JSON.
func from_text(text: String):
	var json = JSON.new()
	return json.data if json.parse(text) == OK else null


func to_bytes(text: String):
	return text.to_utf8_buffer()


# Bytes from `begin` on, before `end`.
func part(bytes, begin: int, end: int):
	return bytes.slice(begin, end)


func start_thread(thread, object, method: String, argument) -> int:
	return thread.start(Callable(object, method).bind(argument))


# Keeps the state of a connection up to date.
func poll(peer) -> void:
	peer.poll()

# SPDX-License-Identifier: MIT
# Addresses of host names, looked up by a thread: no frame waits for a name server. The engine's own queue
# (IP.resolve_hostname_queue_item) holds its lock meanwhile, before Godot 3.5, and every look into it waits.

var _engine
# The lookup under way; null: none.
var _thread = null
var _name := ""
var _mutex := Mutex.new()
# Of the thread, once it is done: an address, "" for none.
var _found = null


func _init(engine):
	_engine = engine


func _notification(what: int) -> void:
	# The thread knows this object.
	if what == NOTIFICATION_PREDELETE and _thread != null:
		_thread.wait_to_finish()


# {"address"} once it is known, {"error"} when there is none, {} while it is looked up: to be asked again.
func find(host: String) -> Dictionary:
	if host.is_valid_ip_address():
		return {"address": host}
	if _thread == null:
		_name = host
		_found = null
		_thread = Thread.new()
		if _engine.start_thread(_thread, self, "_look_up", host) != OK:
			_thread = null
			return {"error": "its name cannot be looked up"}
	_mutex.lock()
	var found = _found
	_mutex.unlock()
	# There is one at a time: also that of a name which nobody wants any more has to end.
	if found == null:
		return {}
	_thread.wait_to_finish()
	_thread = null
	if _name != host:
		return {}
	return {"address": found} if found != "" else {"error": "its name has no address"}


func _look_up(host) -> void:
	var address = IP.resolve_hostname(host)
	_mutex.lock()
	_found = address
	_mutex.unlock()

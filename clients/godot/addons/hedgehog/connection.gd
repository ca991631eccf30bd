# SPDX-License-Identifier: MIT
# A TCP connection that carries lines. Nothing here waits.

# The longest line that is taken from the daemon.
const MAX_LINE := 4 << 20
# What a daemon that does not read may leave unsent.
const MAX_UNSENT := 1 << 20
const MAX_READ := 1 << 16

# Set once it has ended: why.
var ended := ""

var _engine
var _resolver
# Where to, while its name is looked up; empty: nothing is.
var _host := ""
var _port := 0
var _peer := StreamPeerTCP.new()
var _open := false
var _received
var _unsent


func _init(engine, resolver):
	_engine = engine
	_resolver = resolver
	_received = engine.to_bytes("")
	_unsent = engine.to_bytes("")


func start(host: String, port: int) -> void:
	_host = host
	_port = port
	_connect()


# Whether it is established.
func is_open() -> bool:
	return _open and ended == ""


# false: it has ended.
func send(line: String) -> bool:
	if ended != "":
		return false
	_unsent.append_array(_engine.to_bytes(line + "\n"))
	_flush()
	if _unsent.size() > MAX_UNSENT:
		ended = "the daemon does not read from the connection"
	return ended == ""


# What came since the last call: whole lines.
func receive() -> Array:
	var lines = []
	if _host != "":
		_connect()
	if ended != "" or _host != "":
		return lines
	# First: a look at the state of a connection that the daemon has reset discards what it sent before.
	if _open:
		_read_available(lines)
	_engine.poll(_peer)
	var status = _peer.get_status()
	if status == StreamPeerTCP.STATUS_CONNECTING:
		return lines
	if status == StreamPeerTCP.STATUS_CONNECTED:
		if not _open:
			_open = true
			# Small lines would wait up to 40 ms for others.
			_peer.set_no_delay(true)
		_flush()
		_read_available(lines)
	elif ended == "":
		ended = "the daemon closed it" if _open else "the connection failed"
	return lines


func close() -> void:
	_peer.disconnect_from_host()


# Once the address is known.
func _connect() -> void:
	var found = _resolver.find(_host)
	if found.size() == 0:
		return
	_host = ""
	if found.has("error"):
		ended = found.error
	# A name would be looked up here, and waited for.
	elif _peer.connect_to_host(found.address, _port) != OK:
		ended = "it cannot be reached"


func _flush() -> void:
	if not _open or _unsent.size() == 0:
		return
	var sent = _peer.put_partial_data(_unsent)
	if sent[0] != OK:
		ended = "it cannot be written to"
		return
	_unsent = _engine.part(_unsent, sent[1], _unsent.size())


func _read_available(lines: Array) -> void:
	while ended == "" and _peer.get_available_bytes() > 0:
		_read(lines)


func _read(lines: Array) -> void:
	var read = _peer.get_partial_data(int(min(MAX_READ, _peer.get_available_bytes())))
	if read[0] != OK or read[1].size() == 0:
		ended = "the daemon closed it"
		return
	var before = _received.size()
	_received.append_array(read[1])
	var newline = _received.size() - 1
	while newline >= before and _received[newline] != 10:
		newline -= 1
	if newline >= before:
		# Whole lines are decoded, so that no character is torn.
		for line in _engine.part(_received, 0, newline).get_string_from_utf8().split("\n"):
			if line.strip_edges() != "":
				lines.append(line)
		_received = _engine.part(_received, newline + 1, _received.size())
	if _received.size() > MAX_LINE:
		ended = "a line of more than 4 MiB"

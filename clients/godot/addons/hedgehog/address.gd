# SPDX-License-Identifier: MIT
# Where the daemon listens: HEDGEHOG_ADDRESS, and nowhere else if it is set; otherwise 127.0.0.1:7586. Other clients look at the
# daemon's Unix sockets first; Godot has none.

const PORT := 7586


# {"host", "port"}, or {"error"}: one sentence.
static func find(given: String) -> Dictionary:
	var text = given if given != "" else OS.get_environment("HEDGEHOG_ADDRESS")
	return parse(text) if text != "" else {"host": "127.0.0.1", "port": PORT}


# "host", "host:port", "[v6]:port" or a bare IPv6 address, each with "tcp:" in front or without.
static func parse(text: String) -> Dictionary:
	if text.begins_with("unix:") or text.begins_with("/"):
		return _bad(text, "Godot has no Unix sockets")
	if text.begins_with("tls://") or text.begins_with("mdns://"):
		return _bad(text, "the addon supports neither TLS nor discovery; hedgehogctl tunnel %s makes it 127.0.0.1:7586" % text)
	var place = text.substr(4, text.length()) if text.begins_with("tcp:") else text
	var host = place
	var rest = ""
	var colon = place.find(":")
	if place.begins_with("["):
		var close = place.find("]")
		if close < 0:
			return _bad(text, "']' is missing")
		host = place.substr(1, close - 1)
		rest = place.substr(close + 1, place.length())
	elif colon >= 0 and colon == place.rfind(":"):
		host = place.substr(0, colon)
		rest = place.substr(colon, place.length())
	if host == "":
		return _bad(text, "it names no host")
	if rest == "":
		return {"host": host, "port": PORT}
	var port = _port(rest)
	if port == 0:
		return _bad(text, "the port is a number from 1 to 65535")
	return {"host": host, "port": port}


static func describe(address: Dictionary) -> String:
	return ("[%s]:%d" if ":" in address.host else "%s:%d") % [address.host, address.port]


# Of ":7586"; 0: this is none.
static func _port(text: String) -> int:
	if not text.begins_with(":") or text.length() < 2 or text.length() > 6:
		return 0
	for i in range(1, text.length()):
		if not text.substr(i, 1) in "0123456789":
			return 0
	var port = int(text.substr(1, text.length()))
	return port if port <= 65535 else 0


static func _bad(text: String, why: String) -> Dictionary:
	return {"error": "'%s' is no address of a daemon: %s (for example 127.0.0.1:7586 or [::1]:7586)" % [text, why]}

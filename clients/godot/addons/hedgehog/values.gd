# SPDX-License-Identifier: MIT
# A game's values as the protocol writes them.

# What an effect that is renewed every frame lives after the last: a game that hangs lets go of the ball.
const LEASE_MS := 250


# Parameters as JSON has them, without those that are null. A Vector3 (x right, y up, -z forward) becomes a direction of the
# ball (x front, y left, z up).
static func given(params: Dictionary) -> Dictionary:
	var known = {}
	for key in params:
		if params[key] != null:
			known[key] = _json(params[key])
	return known


# Where a number is that JSON cannot write; empty: nowhere.
static func non_finite(value, where: String) -> String:
	var found = ""
	if typeof(value) == typeof(0.5):
		return where if is_nan(value) or is_inf(value) else ""
	if value is Array:
		for i in range(value.size()):
			found = non_finite(value[i], "%s[%d]" % [where, i]) if found == "" else found
	if value is Dictionary:
		for key in value:
			var place = str(key) if where == "" else "%s.%s" % [where, key]
			found = non_finite(value[key], place) if found == "" else found
	return found


# `strength` 0..1 as a level: 0 stays 0; anything above begins where a push can be felt.
static func felt_level(strength: float, limits: Dictionary) -> float:
	if not strength > 0.0 or not float(limits.current_a) > 0.0:
		return 0.0
	var felt = min(1.0, float(limits.felt_a) / float(limits.current_a))
	return felt + (1.0 - felt) * min(1.0, strength)


static func _json(value):
	# JSON's numbers come as floats; where the daemon wants an integer it takes none.
	if typeof(value) == typeof(0.5):
		return int(value) if value == floor(value) and abs(value) < 9.0e15 else value
	if value is Vector3:
		return [-value.z, -value.x, value.y]
	if value is Array:
		var items = []
		for item in value:
			items.append(_json(item))
		return items
	if value is Dictionary:
		var fields = {}
		for key in value:
			fields[key] = _json(value[key])
		return fields
	return value

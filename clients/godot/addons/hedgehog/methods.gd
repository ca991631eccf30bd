# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
# The daemon's methods. What is pointed at comes first, the other parameters by name; protocol/README.md has them at length.
# A direction is "left", [0, 1, 0], Vector3(-1, 0, 0), {"azimuth_deg": 90} or {"pin": 34}: where the pins push out.
extends Node

## The types of events.
const EVENTS = ["derating_ended", "derating_started", "device_attached", "device_detached", "effect_ended",
	"effect_started", "measurement_accepted", "measurement_rejected", "orientation_lost", "orientation_restored", "overrun",
	"shutting_down", "state_changed"]

## Codes of refusals by name: a request's `code` and `error_name`.
const ERROR_CODES = {
	"parse_error": -32700,
	"invalid_request": -32600,
	"method_not_found": -32601,
	"invalid_params": -32602,
	"internal_error": -32603,
	"not_armed": -32000,
	"busy": -32001,
	"no_such_effect": -32002,
	"unauthorized": -32003,
	"forbidden": -32004,
	"device_absent": -32005,
	"unsupported": -32006,
	"refused_thermal": -32007,
	"no_such_pattern": -32008,
	"claimed": -32009,
	"armed": -32010,
}

## By method and parameter: [minimum, maximum], [minimum], the words that are allowed, or null.
const PARAMETERS = {
	"connection.list": {},
	"device.arm": {},
	"device.claim": {"lease_ms": [100, 10000]},
	"device.describe": {},
	"device.emergency_stop": {},
	"device.enter_boot_loader": {},
	"device.list": {},
	"device.release": {},
	"device.status": {},
	"effect.circle": {"axis": null, "ring_deg": [0, 180], "speed_pins_s": [0.1, 100], "sense": ["ccw", "cw"],
		"stepping": ["pin", "smooth"], "frame": ["device", "world", "coil"], "level": [0, 1], "current_a": [0], "force_n": [0],
		"gain": [0, 1], "start_at_ns": [0], "delay_ms": [0, 10000], "attack_ms": [0, 10000], "fade_ms": [0, 10000],
		"attack_level": [0, 1], "fade_level": [0, 1], "waveform": ["constant", "sine", "square", "triangle", "sawtooth", "noise"],
		"frequency_hz": [0.5, 250], "on_fraction": [0.05, 0.95], "duration_ms": [1, 10000], "lease_ms": [100, 10000],
		"on_close": ["stop", "finish"], "slot": null, "priority": [0, 9], "if_limited": ["reduce", "refuse"]},
	"effect.hold": {"direction": null, "frame": ["device", "world", "coil"], "level": [0, 1], "current_a": [0], "force_n": [0],
		"gain": [0, 1], "start_at_ns": [0], "delay_ms": [0, 10000], "attack_ms": [0, 10000], "fade_ms": [0, 10000],
		"attack_level": [0, 1], "fade_level": [0, 1], "waveform": ["constant", "sine", "square", "triangle", "sawtooth", "noise"],
		"frequency_hz": [0.5, 250], "on_fraction": [0.05, 0.95], "duration_ms": [1, 10000], "lease_ms": [100, 10000],
		"on_close": ["stop", "finish"], "slot": null, "priority": [0, 9], "if_limited": ["reduce", "refuse"]},
	"effect.latency": {},
	"effect.play": {"pattern": null, "keyframes": null, "rotate_to": null, "rate": [0.1, 10], "loop": null,
		"frame": ["device", "world", "coil"], "level": [0, 1], "current_a": [0], "force_n": [0], "gain": [0, 1],
		"start_at_ns": [0], "delay_ms": [0, 10000], "attack_ms": [0, 10000], "fade_ms": [0, 10000], "attack_level": [0, 1],
		"fade_level": [0, 1], "waveform": ["constant", "sine", "square", "triangle", "sawtooth", "noise"],
		"frequency_hz": [0.5, 250], "on_fraction": [0.05, 0.95], "duration_ms": [1, 10000], "lease_ms": [100, 10000],
		"on_close": ["stop", "finish"], "slot": null, "priority": [0, 9], "if_limited": ["reduce", "refuse"]},
	"effect.preview": {"method": ["effect.pulse", "effect.circle", "effect.vibrate", "effect.hold", "effect.play"],
		"params": null},
	"effect.pulse": {"direction": null, "frame": ["device", "world", "coil"], "level": [0, 1], "current_a": [0],
		"force_n": [0], "gain": [0, 1], "start_at_ns": [0], "delay_ms": [0, 10000], "attack_ms": [0, 10000],
		"fade_ms": [0, 10000], "attack_level": [0, 1], "fade_level": [0, 1],
		"waveform": ["constant", "sine", "square", "triangle", "sawtooth", "noise"], "frequency_hz": [0.5, 250],
		"on_fraction": [0.05, 0.95], "duration_ms": [1, 10000], "lease_ms": [100, 10000], "on_close": ["stop", "finish"],
		"slot": null, "priority": [0, 9], "if_limited": ["reduce", "refuse"]},
	"effect.stop": {"effect": [1, 4294967295], "slot": null},
	"effect.stop_all": {"scope": ["mine", "all"]},
	"effect.update": {"effect": [1, 4294967295], "direction": null, "pattern": null, "keyframes": null, "rotate_to": null,
		"rate": [0.1, 10], "loop": null, "axis": null, "ring_deg": [0, 180], "speed_pins_s": [0.1, 100], "sense": ["ccw", "cw"],
		"stepping": ["pin", "smooth"], "frame": ["device", "world", "coil"], "level": [0, 1], "current_a": [0], "force_n": [0],
		"gain": [0, 1], "start_at_ns": [0], "delay_ms": [0, 10000], "attack_ms": [0, 10000], "fade_ms": [0, 10000],
		"attack_level": [0, 1], "fade_level": [0, 1], "waveform": ["constant", "sine", "square", "triangle", "sawtooth", "noise"],
		"frequency_hz": [0.5, 250], "on_fraction": [0.05, 0.95], "duration_ms": [1, 10000], "lease_ms": [100, 10000],
		"on_close": ["stop", "finish"], "slot": null, "priority": [0, 9], "if_limited": ["reduce", "refuse"]},
	"effect.vibrate": {"direction": null, "frame": ["device", "world", "coil"], "level": [0, 1], "current_a": [0],
		"force_n": [0], "gain": [0, 1], "start_at_ns": [0], "delay_ms": [0, 10000], "attack_ms": [0, 10000],
		"fade_ms": [0, 10000], "attack_level": [0, 1], "fade_level": [0, 1],
		"waveform": ["constant", "sine", "square", "triangle", "sawtooth", "noise"], "frequency_hz": [0.5, 250],
		"on_fraction": [0.05, 0.95], "duration_ms": [1, 10000], "lease_ms": [100, 10000], "on_close": ["stop", "finish"],
		"slot": null, "priority": [0, 9], "if_limited": ["reduce", "refuse"]},
	"events.history": {"since": null, "types": null, "trips": null, "limit": [1, 1000]},
	"events.subscribe": {"types": null, "scope": ["mine", "all"]},
	"events.unsubscribe": {},
	"hello": {"client": null, "protocol": null, "token": null},
	"orientation.recenter": {"azimuth_deg": [-360, 360]},
	"orientation.set": {"quaternion": null},
	"output.set_gain": {"gain": [0, 1]},
	"pattern.get": {"name": null},
	"pattern.list": {},
	"pattern.put": {"name": null, "keyframes": null, "description": null,
		"waveform": ["constant", "sine", "square", "triangle", "sawtooth", "noise"], "frequency_hz": [0.5, 250],
		"on_fraction": [0.05, 0.95]},
	"pattern.remove": {"name": null},
	"ping": {},
	"sim.set": {"orientation": null, "ambient_c": [-20, 60], "fault": null, "errors": null},
	"sim.truth": {},
	"telemetry.history": {"seconds": [1, 600]},
	"telemetry.subscribe": {"rate_hz": [0.1, 200], "fields": null},
	"telemetry.unsubscribe": {},
	"thermal.forecast": {"current_a": [0], "direction": null,
		"method": ["effect.pulse", "effect.circle", "effect.vibrate", "effect.hold", "effect.play"], "params": null,
		"effect": [1, 4294967295]},
}


## The connections, with their start times and effects.
func connection_list(params: Dictionary = {}):
	return request("connection.list", params)


## Arms the ball once the cause of the stop no longer exists.
func arm(params: Dictionary = {}):
	return request("device.arm", params)


## Exclusive use of the ball until release, end of the connection, or expiry of the lease.
## lease_ms: Ends after it unless renewed; 100 to 10000
func claim(params: Dictionary = {}):
	return request("device.claim", params)


## The ball: pins, coils, limits, calibration, identity.
func describe(params: Dictionary = {}):
	return request("device.describe", params)


## Coils off at the next tick, latched until armed.
func emergency_stop(params: Dictionary = {}):
	return request("device.emergency_stop", params)


## Restarts the board in its boot loader, for a firmware update; rejected while armed.
func enter_boot_loader(params: Dictionary = {}):
	return request("device.enter_boot_loader", params)


## USB and HID devices: which are used, and why the others are not.
func list(params: Dictionary = {}):
	return request("device.list", params)


## Releases the claim.
func release(params: Dictionary = {}):
	return request("device.release", params)


## State of the ball: temperatures, currents, limits, effects.
func status(params: Dictionary = {}):
	return request("device.status", params)


## The field rotates about an axis, from pin to pin.
## axis: The axis of the circle
## ring_deg: Angle between the axis and the circle; 90 is the equator; 0 to 180
## speed_pins_s: Steps a second; a step is the pitch of the pins; 0.1 to 100
## sense: As seen from outside along the axis; ccw, cw
## stepping: From pin to pin, or gliding; pin, smooth
## frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world, coil
## level: Strength as a part of limits.current_a; 0 to 1
## current_a: Strength as a current; at most limits.current_a; at least 0
## force_n: Strength as the force on the pin that is pointed at; at least 0
## gain: Multiplies the strength; 0 to 1
## start_at_ns: Device time of the onset; at least 0
## delay_ms: From now to the onset; 0 to 10000
## attack_ms: Linear rise, inside the duration; 0 to 10000
## fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
## attack_level: Where the rise begins, as a part of the strength; 0 to 1
## fade_level: Where the fall ends, as a part of the strength; 0 to 1
## waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
## frequency_hz: 0.5 to 250
## on_fraction: The part of a period that a square is on; 0.05 to 0.95
## duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
## lease_ms: Ends after it unless renewed; 100 to 10000
## on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
## slot: The connection's own name for an effect
## priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9
## if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
func circle(axis = null, params: Dictionary = {}):
	return request("effect.circle", _with(params, "axis", axis))


## A push that lasts as long as it is renewed.
## direction: Where the pins push out
## frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world, coil
## level: Strength as a part of limits.current_a; 0 to 1
## current_a: Strength as a current; at most limits.current_a; at least 0
## force_n: Strength as the force on the pin that is pointed at; at least 0
## gain: Multiplies the strength; 0 to 1
## start_at_ns: Device time of the onset; at least 0
## delay_ms: From now to the onset; 0 to 10000
## attack_ms: Linear rise, inside the duration; 0 to 10000
## fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
## attack_level: Where the rise begins, as a part of the strength; 0 to 1
## fade_level: Where the fall ends, as a part of the strength; 0 to 1
## waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
## frequency_hz: 0.5 to 250
## on_fraction: The part of a period that a square is on; 0.05 to 0.95
## duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
## lease_ms: Ends after it unless renewed; 100 to 10000
## on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
## slot: The connection's own name for an effect
## priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9
## if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
func hold(direction, params: Dictionary = {}):
	return request("effect.hold", _with(params, "direction", direction))


## How long effects took from their request to the board.
func latency(params: Dictionary = {}):
	return request("effect.latency", params)


## Plays key frames, of a named pattern or its own.
## pattern: The name of a pattern, or keyframes instead
## keyframes: Where and how strongly, at points in time; t_ms never falls
## rotate_to: Patterns face front; this turns the front there by the shortest way
## rate: So many times as fast; 0.1 to 10
## loop: Begins again at its end
## frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world, coil
## level: Strength as a part of limits.current_a; 0 to 1
## current_a: Strength as a current; at most limits.current_a; at least 0
## force_n: Strength as the force on the pin that is pointed at; at least 0
## gain: Multiplies the strength; 0 to 1
## start_at_ns: Device time of the onset; at least 0
## delay_ms: From now to the onset; 0 to 10000
## attack_ms: Linear rise, inside the duration; 0 to 10000
## fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
## attack_level: Where the rise begins, as a part of the strength; 0 to 1
## fade_level: Where the fall ends, as a part of the strength; 0 to 1
## waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
## frequency_hz: 0.5 to 250
## on_fraction: The part of a period that a square is on; 0.05 to 0.95
## duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
## lease_ms: Ends after it unless renewed; 100 to 10000
## on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
## slot: The connection's own name for an effect
## priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9
## if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
func play(pattern = null, params: Dictionary = {}):
	return request("effect.play", _with(params, "pattern", pattern))


## Computes currents and temperatures of an effect without starting it.
## method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
## params: The parameters of that method
func preview(params: Dictionary = {}):
	return request("effect.preview", params)


## One push towards a direction.
## direction: Where the pins push out
## frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world, coil
## level: Strength as a part of limits.current_a; 0 to 1
## current_a: Strength as a current; at most limits.current_a; at least 0
## force_n: Strength as the force on the pin that is pointed at; at least 0
## gain: Multiplies the strength; 0 to 1
## start_at_ns: Device time of the onset; at least 0
## delay_ms: From now to the onset; 0 to 10000
## attack_ms: Linear rise, inside the duration; 0 to 10000
## fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
## attack_level: Where the rise begins, as a part of the strength; 0 to 1
## fade_level: Where the fall ends, as a part of the strength; 0 to 1
## waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
## frequency_hz: 0.5 to 250
## on_fraction: The part of a period that a square is on; 0.05 to 0.95
## duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
## lease_ms: Ends after it unless renewed; 100 to 10000
## on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
## slot: The connection's own name for an effect
## priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9
## if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
func pulse(direction, params: Dictionary = {}):
	return request("effect.pulse", _with(params, "direction", direction))


## Ends one of the connection's own effects.
## effect: The number of an effect, from its admission; 1 to 4294967295
## slot: The connection's own name for an effect
func stop(params: Dictionary = {}):
	return request("effect.stop", params)


## Ends all effects of the connection, or of all connections.
## scope: "all" for effects of others too; mine, all
func stop_all(params: Dictionary = {}):
	return request("effect.stop_all", params)


## Changes a playing effect and renews its lease.
## effect: The number of an effect, from its admission; 1 to 4294967295
## direction: Where the pins push out
## pattern: The name of a pattern, or keyframes instead
## keyframes: Where and how strongly, at points in time; t_ms never falls
## rotate_to: Patterns face front; this turns the front there by the shortest way
## rate: So many times as fast; 0.1 to 10
## loop: Begins again at its end
## axis: The axis of the circle
## ring_deg: Angle between the axis and the circle; 90 is the equator; 0 to 180
## speed_pins_s: Steps a second; a step is the pitch of the pins; 0.1 to 100
## sense: As seen from outside along the axis; ccw, cw
## stepping: From pin to pin, or gliding; pin, smooth
## frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world, coil
## level: Strength as a part of limits.current_a; 0 to 1
## current_a: Strength as a current; at most limits.current_a; at least 0
## force_n: Strength as the force on the pin that is pointed at; at least 0
## gain: Multiplies the strength; 0 to 1
## start_at_ns: Device time of the onset; at least 0
## delay_ms: From now to the onset; 0 to 10000
## attack_ms: Linear rise, inside the duration; 0 to 10000
## fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
## attack_level: Where the rise begins, as a part of the strength; 0 to 1
## fade_level: Where the fall ends, as a part of the strength; 0 to 1
## waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
## frequency_hz: 0.5 to 250
## on_fraction: The part of a period that a square is on; 0.05 to 0.95
## duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
## lease_ms: Ends after it unless renewed; 100 to 10000
## on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
## slot: The connection's own name for an effect
## priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9
## if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
func update(params: Dictionary = {}):
	return request("effect.update", params)


## A push with a waveform.
## direction: Where the pins push out
## frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world, coil
## level: Strength as a part of limits.current_a; 0 to 1
## current_a: Strength as a current; at most limits.current_a; at least 0
## force_n: Strength as the force on the pin that is pointed at; at least 0
## gain: Multiplies the strength; 0 to 1
## start_at_ns: Device time of the onset; at least 0
## delay_ms: From now to the onset; 0 to 10000
## attack_ms: Linear rise, inside the duration; 0 to 10000
## fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
## attack_level: Where the rise begins, as a part of the strength; 0 to 1
## fade_level: Where the fall ends, as a part of the strength; 0 to 1
## waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
## frequency_hz: 0.5 to 250
## on_fraction: The part of a period that a square is on; 0.05 to 0.95
## duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
## lease_ms: Ends after it unless renewed; 100 to 10000
## on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
## slot: The connection's own name for an effect
## priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9
## if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
func vibrate(direction = null, params: Dictionary = {}):
	return request("effect.vibrate", _with(params, "direction", direction))


## Past events, including those before the last start.
## since: Not before this time, RFC 3339
## types: Names of events; default all
## trips
## limit: The newest so many; 1 to 1000
func events_history(params: Dictionary = {}):
	return request("events.history", params)


## Sets the azimuth of the ball's front.
## azimuth_deg: Anticlockwise seen from above; -360 to 360
func orientation_recenter(params: Dictionary = {}):
	return request("orientation.recenter", params)


## Sets the orientation measured by an external sensor.
## quaternion: Device to world, of length 1
func orientation_set(params: Dictionary = {}):
	return request("orientation.set", params)


## Gain applied to all effects; persistent.
## gain: Multiplies the strength; 0 to 1
func output_set_gain(params: Dictionary = {}):
	return request("output.set_gain", params)


## One named pattern with its key frames.
## name: Of a pattern: vendor/name, or that of a shipped one
func pattern_get(params: Dictionary = {}):
	return request("pattern.get", params)


## Lists the named patterns.
func pattern_list(params: Dictionary = {}):
	return request("pattern.list", params)


## Stores a pattern under vendor/name.
## name: Of a pattern: vendor/name, or that of a shipped one
## keyframes: Where and how strongly, at points in time; t_ms never falls
## description: One sentence for whoever chooses a pattern
## waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
## frequency_hz: 0.5 to 250
## on_fraction: The part of a period that a square is on; 0.05 to 0.95
func pattern_put(params: Dictionary = {}):
	return request("pattern.put", params)


## Removes a stored pattern.
## name: Of a pattern: vendor/name, or that of a shipped one
func pattern_remove(params: Dictionary = {}):
	return request("pattern.remove", params)


## The device time.
func ping(params: Dictionary = {}):
	return request("ping", params)


## Sets orientation, ambient temperature and faults of the simulation.
## orientation: Device to world, of length 1
## ambient_c: Temperature of the simulated room; -20 to 60
## fault: Replaces all simulated faults; {} clears them
## errors: Replaces all errors of measurement and of the ball; [] ends them
func sim_set(params: Dictionary = {}):
	return request("sim.set", params)


## True state of the simulated ball.
func sim_truth(params: Dictionary = {}):
	return request("sim.truth", params)


## Temperatures and currents of the last minutes.
## seconds: 1 to 600
func telemetry_history(params: Dictionary = {}):
	return request("telemetry.history", params)


## How long a current or an effect can flow.
## current_a: Strength as a current; at most limits.current_a; at least 0
## direction: Where the pins push out
## method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
## params: The parameters of that method
## effect: The number of an effect, from its admission; 1 to 4294967295
func thermal_forecast(params: Dictionary = {}):
	return request("thermal.forecast", params)


## Overridden: sends, and returns the request.
func request(_method: String, _params: Dictionary = {}):
	return null


## Why the daemon will refuse these parameters, as far as names and ranges tell; empty: they do not.
func problem_of(method: String, params: Dictionary) -> String:
	var known = PARAMETERS.get(method)
	if known == null:
		return "there is no such method"
	for key in params:
		if not known.has(key):
			return "there is no parameter '%s'" % key
		var value = params[key]
		var allowed = known[key]
		if allowed == null or value == null:
			continue
		if typeof(allowed[0]) == TYPE_STRING:
			if not value in allowed:
				return "%s: is none of %s" % [key, allowed]
		elif not (typeof(value) == TYPE_INT or typeof(value) == typeof(0.5)):
			return "%s: is no number" % key
		elif value < allowed[0]:
			return "%s: is below %s" % [key, allowed[0]]
		elif allowed.size() > 1 and value > allowed[1]:
			return "%s: is above %s" % [key, allowed[1]]
	return ""


func _with(params: Dictionary, key: String, value) -> Dictionary:
	var all = params.duplicate()
	all[key] = value
	return all

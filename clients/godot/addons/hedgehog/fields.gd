# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
# The names of the fields of an event and of a status, with their types; the editor completes them. Telemetry has those fields of the
# status that were asked for.
#
#   status[Ball.Fields.Status.TEMPERATURE_C][Ball.Fields.StatusTemperatureC.MODEL]


class EventDelivered:
	const MIN = "min"  ## number
	const MEAN = "mean"  ## number


class EventDisagreement:
	const COIL = "coil"  ## integer
	const BETWEEN = "between"  ## array of texts


class Event:
	const TYPE = "type"  ## text
	const TIME_NS = "time_ns"  ## integer
	const STATE = "state"  ## text; optional
	const EFFECT = "effect"  ## integer; optional
	const SLOT = "slot"  ## text or null; optional
	const SEQ = "seq"  ## integer; optional
	const REASON = "reason"  ## text or null; optional
	const REMEDY = "remedy"  ## text or null; optional
	const ONSET_NS = "onset_ns"  ## integer or null; optional
	const OFFSET_NS = "offset_ns"  ## integer or null; optional
	const DELIVERED = "delivered"  ## EventDelivered; optional
	const MASKED_MS = "masked_ms"  ## integer; optional
	const MIXED_MS = "mixed_ms"  ## integer; optional
	const LIMIT_A = "limit_a"  ## number; optional
	const TEMPERATURE_C = "temperature_c"  ## number; optional
	const CURRENT_A = "current_a"  ## number; optional
	const DISAGREEMENT = "disagreement"  ## EventDisagreement; optional
	const DEVICE = "device"  ## text; optional
	const SKIPPED = "skipped"  ## integer; optional


class StatusTemperatureC:
	const SENSOR = "sensor"  ## number or null
	const MODEL = "model"  ## number or null
	const COILS = "coils"  ## array of 3 numbers
	const UPPER = "upper"  ## number; optional
	const CORE = "core"  ## number; optional
	const SENSORS = "sensors"  ## array of 3 numbers; optional
	const SKIN = "skin"  ## number; optional
	const AGE_MS = "age_ms"  ## integer or null
	const THERMOMETER = "thermometer"  ## number; optional


class StatusFan:
	const SPEED_RPM = "speed_rpm"  ## number or null
	const DUTY = "duty"  ## number
	const COOLING = "cooling"  ## boolean; optional


class StatusOrientationQuaternion:
	const W = "w"  ## number
	const X = "x"  ## number
	const Y = "y"  ## number
	const Z = "z"  ## number


class StatusOrientation:
	const QUATERNION = "quaternion"  ## StatusOrientationQuaternion
	const UP = "up"  ## array of 3 numbers
	const RATE_DEG_S = "rate_deg_s"  ## array of 3 numbers
	const AGE_MS = "age_ms"  ## integer


class StatusEffect:
	const EFFECT = "effect"  ## integer
	const SLOT = "slot"  ## text or null
	const METHOD = "method"  ## text
	const CONNECTION = "connection"  ## integer
	const CLIENT = "client"  ## text or null
	const PRIORITY = "priority"  ## integer
	const PLAYING = "playing"  ## boolean
	const REMAINING_MS = "remaining_ms"  ## integer
	const CURRENT_A = "current_a"  ## number


class StatusLoopLatenessUs:
	const P50 = "p50"  ## number
	const P99 = "p99"  ## number
	const MAX = "max"  ## number


class StatusLoop:
	const RATE_HZ = "rate_hz"  ## number
	const TICKS = "ticks"  ## integer
	const SKIPPED = "skipped"  ## integer
	const LATENESS_US = "lateness_us"  ## StatusLoopLatenessUs


class StatusLink:
	const FRAMES_OUT = "frames_out"  ## integer
	const LOST = "lost"  ## integer
	const ERRORS = "errors"  ## integer


class StatusLastTrip:
	const REASON = "reason"  ## text
	const TIME_NS = "time_ns"  ## integer
	const TEMPERATURE_C = "temperature_c"  ## number or null
	const CURRENT_A = "current_a"  ## number
	const DISAGREEMENT = "disagreement"  ## EventDisagreement; optional


class StatusPins:
	const FORCE_N = "force_n"  ## array of numbers
	const EXTENSION_MM = "extension_mm"  ## array of numbers


class Status:
	const DEVICE = "device"  ## text
	const SIMULATED = "simulated"  ## boolean
	const TIME_NS = "time_ns"  ## integer
	const STATE = "state"  ## text
	const REASON = "reason"  ## text or null
	const SINCE_S = "since_s"  ## number
	const REMEDY = "remedy"  ## text or null
	const TEMPERATURE_C = "temperature_c"  ## StatusTemperatureC
	const LIMIT_A = "limit_a"  ## number
	const HEADROOM_S = "headroom_s"  ## number or null
	const BURST_S = "burst_s"  ## number or null
	const DERATING = "derating"  ## boolean
	const CURRENT_A = "current_a"  ## array of 3 numbers
	const DUTY = "duty"  ## array of 3 numbers
	const SUPPLY_V = "supply_v"  ## number or null
	const FIELD = "field"  ## array of 3 numbers
	const FORCE_N = "force_n"  ## number
	const PIN = "pin"  ## integer or null
	const FAN = "fan"  ## StatusFan
	const ORIENTATION = "orientation"  ## StatusOrientation or null
	const EFFECTS = "effects"  ## array of StatusEffect
	const LOOP = "loop"  ## StatusLoop
	const LINK = "link"  ## StatusLink
	const APPLIED_SEQ = "applied_seq"  ## integer
	const LAST_TRIP = "last_trip"  ## StatusLastTrip or null
	const PINS = "pins"  ## StatusPins; optional

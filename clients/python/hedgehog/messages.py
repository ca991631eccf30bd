# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
"""Types of what the daemon receives and sends. A later daemon may send more."""

from typing import Any, Literal, Mapping, Optional, Sequence, TypedDict, Union

TelemetryField = Literal["device", "simulated", "time_ns", "state", "reason", "since_s", "remedy",
                         "temperature_c", "limit_a", "headroom_s", "burst_s", "derating", "current_a", "duty",
                         "supply_v", "field", "force_n", "pin", "fan", "orientation", "effects", "loop", "link",
                         "applied_seq", "last_trip", "pins"]

DirectionName = Literal["up", "down", "left", "right", "front", "back"]


class DirectionPin(TypedDict):
    pin: int


class DirectionAngles(TypedDict, total=False):
    azimuth_deg: float
    elevation_deg: float


#: "left", [0, 1, 0], {"azimuth_deg": 90} or {"pin": 34}: where the pins push out.
Direction = Union[DirectionName, Sequence[float], DirectionPin, DirectionAngles]

Done = Mapping[str, Any]

HelloRole = Literal["observe", "play", "operate"]


class HelloDevice(TypedDict):
    name: str
    model: str
    simulated: bool


class _HelloLimitsAlways(TypedDict):
    current_a: float
    continuous_a: float
    felt_a: float
    duration_ms: int
    lease_ms: int
    effects: int
    frequency_hz: float
    telemetry_hz: float
    line_bytes: int


class HelloLimits(_HelloLimitsAlways, total=False):
    burst_s: float


class Hello(TypedDict):
    """Hello of protocol/README.md."""

    server: str
    version: str
    protocol: str
    connection: int
    start_id: str
    role: HelloRole
    state: str
    reason: Optional[str]
    remedy: Optional[str]
    methods: Sequence[str]
    device: HelloDevice
    limits: HelloLimits


class Ping(TypedDict):
    """Ping of protocol/README.md."""

    time_ns: int


class ConnectionsConnectionsEffects(TypedDict):
    effect: int
    slot: Optional[str]
    method: str
    connection: int
    client: Optional[str]
    priority: int
    playing: bool
    remaining_ms: int
    current_a: float


class _ConnectionsConnectionsAlways(TypedDict):
    connection: int
    client: Optional[str]
    transport: str
    address: Optional[str]
    role: HelloRole
    since_s: float
    claimed: bool
    effects: Sequence[ConnectionsConnectionsEffects]


class ConnectionsConnections(_ConnectionsConnectionsAlways, total=False):
    uid: int
    pid: int


class Connections(TypedDict):
    """Connections of protocol/README.md."""

    connections: Sequence[ConnectionsConnections]


class _StateAlways(TypedDict):
    state: str
    reason: Optional[str]
    remedy: Optional[str]
    seq: int


class State(_StateAlways, total=False):
    """State of protocol/README.md."""

    on_disk: bool


class Claim(TypedDict):
    """Claim of protocol/README.md."""

    lease_ms: int


class DescriptionPins(TypedDict):
    pin: int
    position: Sequence[float]
    ring: int
    rest_mm: float


class DescriptionCoilsMeasured(TypedDict):
    r25_ohm: Optional[float]
    from_file: Optional[float]
    from_kept: Optional[float]


class _DescriptionCoilsAlways(TypedDict):
    matrix: Sequence[Sequence[float]]
    r25_ohm: Sequence[float]
    inductance_h: float
    supply_v: float


class DescriptionCoils(_DescriptionCoilsAlways, total=False):
    measured: Sequence[DescriptionCoilsMeasured]


class DescriptionThermal(TypedDict):
    winding_j_k: Sequence[float]
    core_j_k: float
    winding_to_core_k_w: Sequence[float]
    core_to_room_fan_k_w: float
    core_to_room_still_k_w: float
    sensor_winding: int
    sensor_lag_s: float


class DescriptionUncertainty(TypedDict):
    thermal: float
    resistance: float
    thermistor_k: float


class DescriptionLimits(TypedDict):
    current_a: float
    continuous_a: float
    felt_a: float
    derate_from_c: float
    sustain_c: float
    zero_c: float
    trip_c: float
    rearm_c: float


class DescriptionCalibration(TypedDict):
    force_n_per_a: float


class DescriptionBoard(TypedDict):
    backend: str
    present: bool
    serial: Optional[str]
    firmware: Optional[str]
    protocol: Optional[str]


class DescriptionImu(TypedDict):
    type: str
    present: bool


class Description(TypedDict):
    """Description of protocol/README.md."""

    name: str
    model: str
    simulated: bool
    arrangement: str
    pins: Sequence[DescriptionPins]
    coils: DescriptionCoils
    thermal: DescriptionThermal
    uncertainty: DescriptionUncertainty
    limits: DescriptionLimits
    calibration: DescriptionCalibration
    gain: float
    board: DescriptionBoard
    imu: DescriptionImu


class _StatusTemperatureCAlways(TypedDict):
    sensor: Optional[float]
    model: Optional[float]
    coils: Sequence[float]
    age_ms: Optional[int]


class StatusTemperatureC(_StatusTemperatureCAlways, total=False):
    upper: float
    core: float
    sensors: Sequence[float]
    skin: float
    thermometer: float


class _StatusFanAlways(TypedDict):
    speed_rpm: Optional[float]
    duty: float


class StatusFan(_StatusFanAlways, total=False):
    cooling: bool


class StatusOrientationQuaternion(TypedDict):
    w: float
    x: float
    y: float
    z: float


class StatusOrientation(TypedDict):
    quaternion: StatusOrientationQuaternion
    up: Sequence[float]
    rate_deg_s: Sequence[float]
    age_ms: int


class StatusLoopLatenessUs(TypedDict):
    p50: float
    p99: float
    max: float


class StatusLoop(TypedDict):
    rate_hz: float
    ticks: int
    skipped: int
    lateness_us: StatusLoopLatenessUs


class StatusLink(TypedDict):
    frames_out: int
    lost: int
    errors: int


class StatusLastTripDisagreement(TypedDict):
    coil: int
    between: Sequence[str]


class _StatusLastTripAlways(TypedDict):
    reason: str
    time_ns: int
    temperature_c: Optional[float]
    current_a: float


class StatusLastTrip(_StatusLastTripAlways, total=False):
    disagreement: StatusLastTripDisagreement


class StatusPins(TypedDict):
    force_n: Sequence[float]
    extension_mm: Sequence[float]


class _StatusAlways(TypedDict):
    device: str
    simulated: bool
    time_ns: int
    state: str
    reason: Optional[str]
    since_s: float
    remedy: Optional[str]
    temperature_c: StatusTemperatureC
    limit_a: float
    headroom_s: Optional[float]
    burst_s: Optional[float]
    derating: bool
    current_a: Sequence[float]
    duty: Sequence[float]
    supply_v: Optional[float]
    field: Sequence[float]
    force_n: float
    pin: Optional[int]
    fan: StatusFan
    orientation: Optional[StatusOrientation]
    effects: Sequence[ConnectionsConnectionsEffects]
    loop: StatusLoop
    link: StatusLink
    applied_seq: int
    last_trip: Optional[StatusLastTrip]


class Status(_StatusAlways, total=False):
    """Status of protocol/README.md."""

    pins: StatusPins


class DevicesDevices(TypedDict):
    path: str
    ids: str
    name: str
    serial: Optional[str]
    firmware: Optional[str]
    protocol: Optional[str]
    use: Optional[str]
    why_not: Optional[str]


class DevicesMissing(TypedDict):
    use: str
    why: str


class Devices(TypedDict):
    """Devices of protocol/README.md."""

    devices: Sequence[DevicesDevices]
    missing: Sequence[DevicesMissing]
    others: int


class _AdmissionAlways(TypedDict):
    effect: int
    accepted: bool
    limited_by: Optional[str]
    current_a: float
    force_n: float
    pin: int
    headroom_s: Optional[float]
    seq: int


class Admission(_AdmissionAlways, total=False):
    """Admission of protocol/README.md."""

    slot: str
    period_ms: float


class Stopped(TypedDict):
    """Stopped of protocol/README.md."""

    stopped: int
    seq: int


class PreviewDelivered(TypedDict):
    min: float
    mean: float


class Preview(TypedDict):
    """Preview of protocol/README.md."""

    duration_ms: int
    step_ms: int
    duty: Sequence[Sequence[float]]
    current_a: Sequence[Sequence[float]]
    peak_current_a: float
    temperature_c: float
    peak_temperature_c: float
    limited_by: Optional[str]
    limited_from_ms: Optional[int]
    delivered: PreviewDelivered


class Latency(TypedDict):
    """Latency of protocol/README.md."""

    effects: int
    received_to_queued_us: Optional[StatusLoopLatenessUs]
    queued_to_applied_us: Optional[StatusLoopLatenessUs]
    applied_to_written_us: Optional[StatusLoopLatenessUs]
    received_to_written_us: Optional[StatusLoopLatenessUs]


class EventsSubscription(TypedDict):
    """EventsSubscription of protocol/README.md."""

    state: str
    reason: Optional[str]
    derating: bool
    limit_a: float


class _HistoryEventsAlways(TypedDict):
    at: str
    type: str
    time_ns: int


class HistoryEvents(_HistoryEventsAlways, total=False):
    state: str
    effect: int
    slot: Optional[str]
    seq: int
    reason: Optional[str]
    remedy: Optional[str]
    onset_ns: Optional[int]
    offset_ns: Optional[int]
    delivered: PreviewDelivered
    masked_ms: int
    mixed_ms: int
    limit_a: float
    temperature_c: float
    current_a: float
    disagreement: StatusLastTripDisagreement
    device: str
    skipped: int
    method: str
    client: str
    recording: str
    count: int
    last: str


class History(TypedDict):
    """History of protocol/README.md."""

    events: Sequence[HistoryEvents]
    more: bool


class Recentered(TypedDict):
    """Recentered of protocol/README.md."""

    yaw_offset_deg: float


class Gain(TypedDict):
    """Gain of protocol/README.md."""

    gain: float
    seq: int


class PatternsPatterns(TypedDict):
    name: str
    description: str
    duration_ms: int
    keyframes: int
    shipped: bool


class Patterns(TypedDict):
    """Patterns of protocol/README.md."""

    patterns: Sequence[PatternsPatterns]


PatternWaveform = Literal["constant", "sine", "square", "triangle", "sawtooth", "noise"]

PatternKeyframesEase = Literal["linear", "step", "smooth"]


class _PatternKeyframesAlways(TypedDict):
    t_ms: float
    level: float


class PatternKeyframes(_PatternKeyframesAlways, total=False):
    direction: Direction
    ease: PatternKeyframesEase


class _PatternAlways(TypedDict):
    name: str
    keyframes: Sequence[PatternKeyframes]
    duration_ms: int
    shipped: bool


class Pattern(_PatternAlways, total=False):
    """Pattern of protocol/README.md."""

    description: str
    waveform: PatternWaveform
    frequency_hz: float
    on_fraction: float


class PatternSummary(TypedDict):
    """PatternSummary of protocol/README.md."""

    name: str
    description: str
    duration_ms: int
    keyframes: int
    shipped: bool


class _SimulatedWorldErrorsAlways(TypedDict):
    kind: str
    value: float


class SimulatedWorldErrors(_SimulatedWorldErrorsAlways, total=False):
    coil: int
    ramp_s: float


class SimulatedWorld(TypedDict):
    """SimulatedWorld of protocol/README.md."""

    ambient_c: float
    faults: Sequence[str]
    coil: int
    errors: Sequence[SimulatedWorldErrors]


class SimulatedTruth(TypedDict):
    """SimulatedTruth of protocol/README.md."""

    coils_c: Sequence[float]
    core_c: float
    skin_c: float
    current_a: Sequence[float]
    ambient_c: float


class TelemetrySubscription(TypedDict):
    """TelemetrySubscription of protocol/README.md."""

    rate_hz: float
    fields: Sequence[TelemetryField]


class _TelemetryHistorySamplesAlways(TypedDict):
    age_s: float
    current_a: float
    peak_a: float
    limit_a: float
    duty: Sequence[float]
    headroom_s: Optional[float]


class TelemetryHistorySamples(_TelemetryHistorySamplesAlways, total=False):
    coils_c: Sequence[float]
    upper_c: float
    sensor_c: float


class TelemetryHistory(TypedDict):
    """TelemetryHistory of protocol/README.md."""

    time_ns: int
    step_s: float
    samples: Sequence[TelemetryHistorySamples]


class Forecast(TypedDict):
    """Forecast of protocol/README.md."""

    seconds_to_derating: Optional[float]
    seconds_to_limit: Optional[float]
    sustainable_a: float
    recovery_s: Optional[float]
    temperature_known: bool


class _TelemetryAlways(TypedDict):
    time_ns: int


class Telemetry(_TelemetryAlways, total=False):
    """Telemetry of protocol/README.md."""

    device: str
    simulated: bool
    state: str
    reason: Optional[str]
    since_s: float
    remedy: Optional[str]
    temperature_c: StatusTemperatureC
    limit_a: float
    headroom_s: Optional[float]
    burst_s: Optional[float]
    derating: bool
    current_a: Sequence[float]
    duty: Sequence[float]
    supply_v: Optional[float]
    field: Sequence[float]
    force_n: float
    pin: Optional[int]
    fan: StatusFan
    orientation: Optional[StatusOrientation]
    effects: Sequence[ConnectionsConnectionsEffects]
    loop: StatusLoop
    link: StatusLink
    applied_seq: int
    last_trip: Optional[StatusLastTrip]
    pins: StatusPins


class _EventAlways(TypedDict):
    type: str
    time_ns: int


class Event(_EventAlways, total=False):
    """Event of protocol/README.md."""

    state: str
    effect: int
    slot: Optional[str]
    seq: int
    reason: Optional[str]
    remedy: Optional[str]
    onset_ns: Optional[int]
    offset_ns: Optional[int]
    delivered: PreviewDelivered
    masked_ms: int
    mixed_ms: int
    limit_a: float
    temperature_c: float
    current_a: float
    disagreement: StatusLastTripDisagreement
    device: str
    skipped: int


ErrorDataDevice = Literal["board", "imu"]


class _ErrorDataAlways(TypedDict):
    name: str


class ErrorData(_ErrorDataAlways, total=False):
    field: str
    limit: Any
    value: Any
    state: str
    reason: str
    remedy: str
    role_needed: HelloRole
    retry_after_ms: int
    device: ErrorDataDevice
    limit_a: float


EventType = Literal["derating_ended", "derating_started", "device_attached", "device_detached", "effect_ended",
                    "effect_started", "measurement_accepted", "measurement_rejected", "orientation_lost",
                    "orientation_restored", "overrun", "shutting_down", "state_changed"]

Sense = Literal["ccw", "cw"]

Stepping = Literal["pin", "smooth"]

Frame = Literal["device", "world", "coil"]

OnClose = Literal["stop", "finish"]

IfLimited = Literal["reduce", "refuse"]

Method = Literal["effect.pulse", "effect.circle", "effect.vibrate", "effect.hold", "effect.play"]

Scope = Literal["mine", "all"]


class Fault(TypedDict, total=False):
    faults: Sequence[str]
    coil: int

// SPDX-License-Identifier: MIT
// Written by generate.mjs from protocol/schema/openrpc.json.
// Results, events, errors and parameters. A later daemon may send more than they name.

/** Where the pins push out. */
export type Direction = "up" | "down" | "left" | "right" | "front" | "back" | [number, number, number] | {
  pin: number;
} | {
  azimuth_deg?: number;
  elevation_deg?: number;
};

/** Done */
export type Done = object;

export interface Hello {
  server: string;
  version: string;
  protocol: string;
  connection: number;
  start_id: string;
  role: "observe" | "play" | "operate";
  state: string;
  reason: string | null;
  remedy: string | null;
  methods: Array<string>;
  device: {
    name: string;
    model: string;
    simulated: boolean;
  };
  limits: {
    current_a: number;
    continuous_a: number;
    felt_a: number;
    duration_ms: number;
    lease_ms: number;
    effects: number;
    frequency_hz: number;
    telemetry_hz: number;
    line_bytes: number;
    burst_s?: number;
  };
}

export interface Ping {
  time_ns: number;
}

export interface Connections {
  connections: Array<{
    connection: number;
    client: string | null;
    transport: string;
    address: string | null;
    uid?: number;
    pid?: number;
    role: "observe" | "play" | "operate";
    since_s: number;
    claimed: boolean;
    effects: Array<{
      effect: number;
      slot: string | null;
      method: string;
      connection: number;
      client: string | null;
      priority: number;
      playing: boolean;
      remaining_ms: number;
      current_a: number;
    }>;
  }>;
}

export interface State {
  state: string;
  reason: string | null;
  remedy: string | null;
  seq: number;
  on_disk?: boolean;
}

export interface Claim {
  lease_ms: number;
}

export interface Description {
  name: string;
  model: string;
  simulated: boolean;
  arrangement: string;
  pins: Array<{
    pin: number;
    position: [number, number, number];
    ring: number;
    rest_mm: number;
  }>;
  coils: {
    matrix: Array<[number, number, number]>;
    r25_ohm: [number, number, number];
    inductance_h: number;
    supply_v: number;
    measured?: Array<{
      r25_ohm: number | null;
      from_file: number | null;
      from_kept: number | null;
    }>;
  };
  thermal: {
    winding_j_k: [number, number, number];
    core_j_k: number;
    winding_to_core_k_w: [number, number, number];
    core_to_room_fan_k_w: number;
    core_to_room_still_k_w: number;
    sensor_winding: number;
    sensor_lag_s: number;
  };
  uncertainty: {
    thermal: number;
    resistance: number;
    thermistor_k: number;
  };
  limits: {
    current_a: number;
    continuous_a: number;
    felt_a: number;
    derate_from_c: number;
    sustain_c: number;
    zero_c: number;
    trip_c: number;
    rearm_c: number;
  };
  calibration: {
    force_n_per_a: number;
  };
  gain: number;
  board: {
    backend: string;
    present: boolean;
    serial: string | null;
    firmware: string | null;
    protocol: string | null;
  };
  imu: {
    type: string;
    present: boolean;
  };
}

export interface Status {
  device: string;
  simulated: boolean;
  time_ns: number;
  state: string;
  reason: string | null;
  since_s: number;
  remedy: string | null;
  temperature_c: {
    sensor: number | null;
    model: number | null;
    coils: [number, number, number];
    upper?: number;
    core?: number;
    sensors?: [number, number, number];
    skin?: number;
    age_ms: number | null;
    thermometer?: number;
  };
  limit_a: number;
  headroom_s: number | null;
  burst_s: number | null;
  derating: boolean;
  current_a: [number, number, number];
  duty: [number, number, number];
  supply_v: number | null;
  field: [number, number, number];
  force_n: number;
  pin: number | null;
  fan: {
    speed_rpm: number | null;
    duty: number;
    cooling?: boolean;
  };
  orientation: {
    quaternion: {
      w: number;
      x: number;
      y: number;
      z: number;
    };
    up: [number, number, number];
    rate_deg_s: [number, number, number];
    age_ms: number;
  } | null;
  effects: Array<{
    effect: number;
    slot: string | null;
    method: string;
    connection: number;
    client: string | null;
    priority: number;
    playing: boolean;
    remaining_ms: number;
    current_a: number;
  }>;
  loop: {
    rate_hz: number;
    ticks: number;
    skipped: number;
    lateness_us: {
      p50: number;
      p99: number;
      max: number;
    };
  };
  link: {
    frames_out: number;
    lost: number;
    errors: number;
  };
  applied_seq: number;
  last_trip: {
    reason: string;
    time_ns: number;
    temperature_c: number | null;
    current_a: number;
    disagreement?: {
      coil: number;
      between: Array<string>;
    };
  } | null;
  pins?: {
    force_n: Array<number>;
    extension_mm: Array<number>;
  };
}

export interface Devices {
  devices: Array<{
    path: string;
    ids: string;
    name: string;
    serial: string | null;
    firmware: string | null;
    protocol: string | null;
    use: string | null;
    why_not: string | null;
  }>;
  missing: Array<{
    use: string;
    why: string;
  }>;
  others: number;
}

export interface Admission {
  effect: number;
  slot?: string;
  accepted: boolean;
  limited_by: string | null;
  current_a: number;
  force_n: number;
  pin: number;
  headroom_s: number | null;
  seq: number;
  period_ms?: number;
}

export interface Stopped {
  stopped: number;
  seq: number;
}

export interface Preview {
  duration_ms: number;
  step_ms: number;
  duty: Array<[number, number, number]>;
  current_a: Array<[number, number, number]>;
  peak_current_a: number;
  temperature_c: number;
  peak_temperature_c: number;
  limited_by: string | null;
  limited_from_ms: number | null;
  delivered: {
    min: number;
    mean: number;
  };
}

export interface Latency {
  effects: number;
  received_to_queued_us: {
    p50: number;
    p99: number;
    max: number;
  } | null;
  queued_to_applied_us: {
    p50: number;
    p99: number;
    max: number;
  } | null;
  applied_to_written_us: {
    p50: number;
    p99: number;
    max: number;
  } | null;
  received_to_written_us: {
    p50: number;
    p99: number;
    max: number;
  } | null;
}

export interface EventsSubscription {
  state: string;
  reason: string | null;
  derating: boolean;
  limit_a: number;
}

export interface History {
  events: Array<{
    at: string;
    type: string;
    time_ns: number;
    state?: string;
    effect?: number;
    slot?: string | null;
    seq?: number;
    reason?: string | null;
    remedy?: string | null;
    onset_ns?: number | null;
    offset_ns?: number | null;
    delivered?: {
      min: number;
      mean: number;
    };
    masked_ms?: number;
    mixed_ms?: number;
    limit_a?: number;
    temperature_c?: number;
    current_a?: number;
    disagreement?: {
      coil: number;
      between: Array<string>;
    };
    device?: string;
    skipped?: number;
    method?: string;
    client?: string;
    recording?: string;
    count?: number;
    last?: string;
  }>;
  more: boolean;
}

export interface Recentered {
  yaw_offset_deg: number;
}

export interface Gain {
  gain: number;
  seq: number;
}

export interface Patterns {
  patterns: Array<{
    name: string;
    description: string;
    duration_ms: number;
    keyframes: number;
    shipped: boolean;
  }>;
}

export interface Pattern {
  name: string;
  description?: string;
  waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
  frequency_hz?: number;
  on_fraction?: number;
  keyframes: Array<{
    t_ms: number;
    direction?: Direction;
    level: number;
    ease?: "linear" | "step" | "smooth";
  }>;
  duration_ms: number;
  shipped: boolean;
}

export interface PatternSummary {
  name: string;
  description: string;
  duration_ms: number;
  keyframes: number;
  shipped: boolean;
}

export interface SimulatedWorld {
  ambient_c: number;
  faults: Array<string>;
  coil: number;
  errors: Array<{
    kind: string;
    coil?: number;
    value: number;
    ramp_s?: number;
  }>;
}

export interface SimulatedTruth {
  coils_c: Array<number>;
  core_c: number;
  skin_c: number;
  current_a: Array<number>;
  ambient_c: number;
}

export interface TelemetrySubscription {
  rate_hz: number;
  fields: Array<"device" | "simulated" | "time_ns" | "state" | "reason" | "since_s" | "remedy" | "temperature_c" | "limit_a" | "headroom_s" | "burst_s" | "derating" | "current_a" | "duty" | "supply_v" | "field" | "force_n" | "pin" | "fan" | "orientation" | "effects" | "loop" | "link" | "applied_seq" | "last_trip" | "pins">;
}

export interface TelemetryHistory {
  time_ns: number;
  step_s: number;
  samples: Array<{
    age_s: number;
    coils_c?: [number, number, number];
    upper_c?: number;
    sensor_c?: number;
    current_a: number;
    peak_a: number;
    limit_a: number;
    duty: [number, number, number];
    headroom_s: number | null;
  }>;
}

export interface Forecast {
  seconds_to_derating: number | null;
  seconds_to_limit: number | null;
  sustainable_a: number;
  recovery_s: number | null;
  temperature_known: boolean;
}

export interface Telemetry {
  device?: string;
  simulated?: boolean;
  time_ns: number;
  state?: string;
  reason?: string | null;
  since_s?: number;
  remedy?: string | null;
  temperature_c?: {
    sensor: number | null;
    model: number | null;
    coils: [number, number, number];
    upper?: number;
    core?: number;
    sensors?: [number, number, number];
    skin?: number;
    age_ms: number | null;
    thermometer?: number;
  };
  limit_a?: number;
  headroom_s?: number | null;
  burst_s?: number | null;
  derating?: boolean;
  current_a?: [number, number, number];
  duty?: [number, number, number];
  supply_v?: number | null;
  field?: [number, number, number];
  force_n?: number;
  pin?: number | null;
  fan?: {
    speed_rpm: number | null;
    duty: number;
    cooling?: boolean;
  };
  orientation?: {
    quaternion: {
      w: number;
      x: number;
      y: number;
      z: number;
    };
    up: [number, number, number];
    rate_deg_s: [number, number, number];
    age_ms: number;
  } | null;
  effects?: Array<{
    effect: number;
    slot: string | null;
    method: string;
    connection: number;
    client: string | null;
    priority: number;
    playing: boolean;
    remaining_ms: number;
    current_a: number;
  }>;
  loop?: {
    rate_hz: number;
    ticks: number;
    skipped: number;
    lateness_us: {
      p50: number;
      p99: number;
      max: number;
    };
  };
  link?: {
    frames_out: number;
    lost: number;
    errors: number;
  };
  applied_seq?: number;
  last_trip?: {
    reason: string;
    time_ns: number;
    temperature_c: number | null;
    current_a: number;
    disagreement?: {
      coil: number;
      between: Array<string>;
    };
  } | null;
  pins?: {
    force_n: Array<number>;
    extension_mm: Array<number>;
  };
}

export interface BallEvent {
  type: "derating_ended" | "derating_started" | "device_attached" | "device_detached" | "effect_ended" | "effect_started" | "measurement_accepted" | "measurement_rejected" | "orientation_lost" | "orientation_restored" | "overrun" | "shutting_down" | "state_changed" | (string & {});
  time_ns: number;
  state?: string;
  effect?: number;
  slot?: string | null;
  seq?: number;
  reason?: string | null;
  remedy?: string | null;
  onset_ns?: number | null;
  offset_ns?: number | null;
  delivered?: {
    min: number;
    mean: number;
  };
  masked_ms?: number;
  mixed_ms?: number;
  limit_a?: number;
  temperature_c?: number;
  current_a?: number;
  disagreement?: {
    coil: number;
    between: Array<string>;
  };
  device?: string;
  skipped?: number;
}

/** `data` of a refusal. */
export interface ErrorData {
  name: string;
  field?: string;
  limit?: unknown;
  value?: unknown;
  state?: string;
  reason?: string;
  remedy?: string;
  role_needed?: "observe" | "play" | "operate";
  retry_after_ms?: number;
  device?: "board" | "imu";
  limit_a?: number;
}

/** The types of events. */
export type EventType = "derating_ended" | "derating_started" | "device_attached" | "device_detached" | "effect_ended" | "effect_started" | "measurement_accepted" | "measurement_rejected" | "orientation_lost" | "orientation_restored" | "overrun" | "shutting_down" | "state_changed";

/** Codes of refusals, by name. */
export declare const ErrorCode: {
  /** The line is not JSON. */
  readonly parse_error: -32700;
  /** JSON, but no request. */
  readonly invalid_request: -32600;
  /** There is no such method. */
  readonly method_not_found: -32601;
  /** A parameter is unknown, missing, of the wrong type, out of range, or at odds with another. */
  readonly invalid_params: -32602;
  /** A bug; or the request was applied, but not written to disk. */
  readonly internal_error: -32603;
  /** Nothing can be played: state, reason and remedy say why. */
  readonly not_armed: -32000;
  /** A queue or pool is full, or the daemon is stopping; nothing was changed. */
  readonly busy: -32001;
  /** The effect has ended, or belongs to another connection. */
  readonly no_such_effect: -32002;
  /** The token is unknown or revoked. */
  readonly unauthorized: -32003;
  /** It needs role_needed. */
  readonly forbidden: -32004;
  /** There is no board, or no orientation sensor. */
  readonly device_absent: -32005;
  /** Not by this server, not in this configuration. */
  readonly unsupported: -32006;
  /** The thermal limit would reduce the effect, and if_limited is refuse. */
  readonly refused_thermal: -32007;
  /** There is no pattern of that name. */
  readonly no_such_pattern: -32008;
  /** Another client has exclusive use of the ball, or sets its orientation. */
  readonly claimed: -32009;
  /** It is refused while the ball is armed. */
  readonly armed: -32010;
};
export type ErrorName = keyof typeof ErrorCode;

export type ConnectionListParams = Record<string, never>;

export type DeviceArmParams = Record<string, never>;

export interface DeviceClaimParams {
  /** Ends after it unless renewed. 100 to 10000 */
  lease_ms?: number;
}

export type DeviceDescribeParams = Record<string, never>;

export type DeviceEmergencyStopParams = Record<string, never>;

export type DeviceEnterBootLoaderParams = Record<string, never>;

export type DeviceListParams = Record<string, never>;

export type DeviceReleaseParams = Record<string, never>;

export type DeviceStatusParams = Record<string, never>;

export interface EffectCircleParams {
  /** The axis of the circle. */
  axis?: Direction;
  /** Angle between the axis and the circle; 90 is the equator. 0 to 180 */
  ring_deg?: number;
  /** Steps a second; a step is the pitch of the pins. 0.1 to 100 */
  speed_pins_s?: number;
  /** As seen from outside along the axis. */
  sense?: "ccw" | "cw";
  /** From pin to pin, or gliding. */
  stepping?: "pin" | "smooth";
  /** The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A). */
  frame?: "device" | "world" | "coil";
  /** Strength as a part of limits.current_a. 0 to 1 */
  level?: number;
  /** Strength as a current; at most limits.current_a. at least 0 */
  current_a?: number;
  /** Strength as the force on the pin that is pointed at. at least 0 */
  force_n?: number;
  /** Multiplies the strength. 0 to 1 */
  gain?: number;
  /** Device time of the onset. at least 0 */
  start_at_ns?: number;
  /** From now to the onset. 0 to 10000 */
  delay_ms?: number;
  /** Linear rise, inside the duration. 0 to 10000 */
  attack_ms?: number;
  /** Linear fall, inside the duration; not with a lease. 0 to 10000 */
  fade_ms?: number;
  /** Where the rise begins, as a part of the strength. 0 to 1 */
  attack_level?: number;
  /** Where the fall ends, as a part of the strength. 0 to 1 */
  fade_level?: number;
  /** Runs between 0 and the strength. */
  waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
  /** 0.5 to 250 */
  frequency_hz?: number;
  /** The part of a period that a square is on. 0.05 to 0.95 */
  on_fraction?: number;
  /** The effect ends after it. Never together with lease_ms. 1 to 10000 */
  duration_ms?: number;
  /** Ends after it unless renewed. 100 to 10000 */
  lease_ms?: number;
  /** "finish" lets an effect of up to 2000 ms play out after the connection ended. */
  on_close?: "stop" | "finish";
  /** The connection's own name for an effect. */
  slot?: string;
  /** Only effects of the highest active priority are output; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of a reduced effect. */
  if_limited?: "reduce" | "refuse";
}

export interface EffectHoldParams {
  /** Where the pins push out. */
  direction: Direction;
  /** The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A). */
  frame?: "device" | "world" | "coil";
  /** Strength as a part of limits.current_a. 0 to 1 */
  level?: number;
  /** Strength as a current; at most limits.current_a. at least 0 */
  current_a?: number;
  /** Strength as the force on the pin that is pointed at. at least 0 */
  force_n?: number;
  /** Multiplies the strength. 0 to 1 */
  gain?: number;
  /** Device time of the onset. at least 0 */
  start_at_ns?: number;
  /** From now to the onset. 0 to 10000 */
  delay_ms?: number;
  /** Linear rise, inside the duration. 0 to 10000 */
  attack_ms?: number;
  /** Linear fall, inside the duration; not with a lease. 0 to 10000 */
  fade_ms?: number;
  /** Where the rise begins, as a part of the strength. 0 to 1 */
  attack_level?: number;
  /** Where the fall ends, as a part of the strength. 0 to 1 */
  fade_level?: number;
  /** Runs between 0 and the strength. */
  waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
  /** 0.5 to 250 */
  frequency_hz?: number;
  /** The part of a period that a square is on. 0.05 to 0.95 */
  on_fraction?: number;
  /** The effect ends after it. Never together with lease_ms. 1 to 10000 */
  duration_ms?: number;
  /** Ends after it unless renewed. 100 to 10000 */
  lease_ms?: number;
  /** "finish" lets an effect of up to 2000 ms play out after the connection ended. */
  on_close?: "stop" | "finish";
  /** The connection's own name for an effect. */
  slot?: string;
  /** Only effects of the highest active priority are output; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of a reduced effect. */
  if_limited?: "reduce" | "refuse";
}

export type EffectLatencyParams = Record<string, never>;

export interface EffectPlayParams {
  /** The name of a pattern, or keyframes instead. */
  pattern?: string;
  /** Where and how strongly, at points in time; t_ms never falls. */
  keyframes?: Array<{
    t_ms: number;
    direction?: Direction;
    level: number;
    ease?: "linear" | "step" | "smooth";
  }>;
  /** Patterns face front; this turns the front there by the shortest way. */
  rotate_to?: Direction;
  /** So many times as fast. 0.1 to 10 */
  rate?: number;
  /** Begins again at its end. */
  loop?: boolean;
  /** The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A). */
  frame?: "device" | "world" | "coil";
  /** Strength as a part of limits.current_a. 0 to 1 */
  level?: number;
  /** Strength as a current; at most limits.current_a. at least 0 */
  current_a?: number;
  /** Strength as the force on the pin that is pointed at. at least 0 */
  force_n?: number;
  /** Multiplies the strength. 0 to 1 */
  gain?: number;
  /** Device time of the onset. at least 0 */
  start_at_ns?: number;
  /** From now to the onset. 0 to 10000 */
  delay_ms?: number;
  /** Linear rise, inside the duration. 0 to 10000 */
  attack_ms?: number;
  /** Linear fall, inside the duration; not with a lease. 0 to 10000 */
  fade_ms?: number;
  /** Where the rise begins, as a part of the strength. 0 to 1 */
  attack_level?: number;
  /** Where the fall ends, as a part of the strength. 0 to 1 */
  fade_level?: number;
  /** Runs between 0 and the strength. */
  waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
  /** 0.5 to 250 */
  frequency_hz?: number;
  /** The part of a period that a square is on. 0.05 to 0.95 */
  on_fraction?: number;
  /** The effect ends after it. Never together with lease_ms. 1 to 10000 */
  duration_ms?: number;
  /** Ends after it unless renewed. 100 to 10000 */
  lease_ms?: number;
  /** "finish" lets an effect of up to 2000 ms play out after the connection ended. */
  on_close?: "stop" | "finish";
  /** The connection's own name for an effect. */
  slot?: string;
  /** Only effects of the highest active priority are output; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of a reduced effect. */
  if_limited?: "reduce" | "refuse";
}

export interface EffectPreviewParams {
  /** A method that plays. */
  method: "effect.pulse" | "effect.circle" | "effect.vibrate" | "effect.hold" | "effect.play";
  /** The parameters of that method. */
  params: object;
}

export interface EffectPulseParams {
  /** Where the pins push out. */
  direction: Direction;
  /** The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A). */
  frame?: "device" | "world" | "coil";
  /** Strength as a part of limits.current_a. 0 to 1 */
  level?: number;
  /** Strength as a current; at most limits.current_a. at least 0 */
  current_a?: number;
  /** Strength as the force on the pin that is pointed at. at least 0 */
  force_n?: number;
  /** Multiplies the strength. 0 to 1 */
  gain?: number;
  /** Device time of the onset. at least 0 */
  start_at_ns?: number;
  /** From now to the onset. 0 to 10000 */
  delay_ms?: number;
  /** Linear rise, inside the duration. 0 to 10000 */
  attack_ms?: number;
  /** Linear fall, inside the duration; not with a lease. 0 to 10000 */
  fade_ms?: number;
  /** Where the rise begins, as a part of the strength. 0 to 1 */
  attack_level?: number;
  /** Where the fall ends, as a part of the strength. 0 to 1 */
  fade_level?: number;
  /** Runs between 0 and the strength. */
  waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
  /** 0.5 to 250 */
  frequency_hz?: number;
  /** The part of a period that a square is on. 0.05 to 0.95 */
  on_fraction?: number;
  /** The effect ends after it. Never together with lease_ms. 1 to 10000 */
  duration_ms?: number;
  /** Ends after it unless renewed. 100 to 10000 */
  lease_ms?: number;
  /** "finish" lets an effect of up to 2000 ms play out after the connection ended. */
  on_close?: "stop" | "finish";
  /** The connection's own name for an effect. */
  slot?: string;
  /** Only effects of the highest active priority are output; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of a reduced effect. */
  if_limited?: "reduce" | "refuse";
}

export interface EffectStopParams {
  /** The number of an effect, from its admission. 1 to 4294967295 */
  effect?: number;
  /** The connection's own name for an effect. */
  slot?: string;
}

export interface EffectStopAllParams {
  /** "all" for effects of others too. */
  scope?: "mine" | "all";
}

export interface EffectUpdateParams {
  /** The number of an effect, from its admission. 1 to 4294967295 */
  effect?: number;
  /** Where the pins push out. */
  direction?: Direction;
  /** The name of a pattern, or keyframes instead. */
  pattern?: string;
  /** Where and how strongly, at points in time; t_ms never falls. */
  keyframes?: Array<{
    t_ms: number;
    direction?: Direction;
    level: number;
    ease?: "linear" | "step" | "smooth";
  }>;
  /** Patterns face front; this turns the front there by the shortest way. */
  rotate_to?: Direction;
  /** So many times as fast. 0.1 to 10 */
  rate?: number;
  /** Begins again at its end. */
  loop?: boolean;
  /** The axis of the circle. */
  axis?: Direction;
  /** Angle between the axis and the circle; 90 is the equator. 0 to 180 */
  ring_deg?: number;
  /** Steps a second; a step is the pitch of the pins. 0.1 to 100 */
  speed_pins_s?: number;
  /** As seen from outside along the axis. */
  sense?: "ccw" | "cw";
  /** From pin to pin, or gliding. */
  stepping?: "pin" | "smooth";
  /** The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A). */
  frame?: "device" | "world" | "coil";
  /** Strength as a part of limits.current_a. 0 to 1 */
  level?: number;
  /** Strength as a current; at most limits.current_a. at least 0 */
  current_a?: number;
  /** Strength as the force on the pin that is pointed at. at least 0 */
  force_n?: number;
  /** Multiplies the strength. 0 to 1 */
  gain?: number;
  /** Device time of the onset. at least 0 */
  start_at_ns?: number;
  /** From now to the onset. 0 to 10000 */
  delay_ms?: number;
  /** Linear rise, inside the duration. 0 to 10000 */
  attack_ms?: number;
  /** Linear fall, inside the duration; not with a lease. 0 to 10000 */
  fade_ms?: number;
  /** Where the rise begins, as a part of the strength. 0 to 1 */
  attack_level?: number;
  /** Where the fall ends, as a part of the strength. 0 to 1 */
  fade_level?: number;
  /** Runs between 0 and the strength. */
  waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
  /** 0.5 to 250 */
  frequency_hz?: number;
  /** The part of a period that a square is on. 0.05 to 0.95 */
  on_fraction?: number;
  /** The effect ends after it. Never together with lease_ms. 1 to 10000 */
  duration_ms?: number;
  /** Ends after it unless renewed. 100 to 10000 */
  lease_ms?: number;
  /** "finish" lets an effect of up to 2000 ms play out after the connection ended. */
  on_close?: "stop" | "finish";
  /** The connection's own name for an effect. */
  slot?: string;
  /** Only effects of the highest active priority are output; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of a reduced effect. */
  if_limited?: "reduce" | "refuse";
}

export interface EffectVibrateParams {
  /** Where the pins push out. */
  direction?: Direction;
  /** The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A). */
  frame?: "device" | "world" | "coil";
  /** Strength as a part of limits.current_a. 0 to 1 */
  level?: number;
  /** Strength as a current; at most limits.current_a. at least 0 */
  current_a?: number;
  /** Strength as the force on the pin that is pointed at. at least 0 */
  force_n?: number;
  /** Multiplies the strength. 0 to 1 */
  gain?: number;
  /** Device time of the onset. at least 0 */
  start_at_ns?: number;
  /** From now to the onset. 0 to 10000 */
  delay_ms?: number;
  /** Linear rise, inside the duration. 0 to 10000 */
  attack_ms?: number;
  /** Linear fall, inside the duration; not with a lease. 0 to 10000 */
  fade_ms?: number;
  /** Where the rise begins, as a part of the strength. 0 to 1 */
  attack_level?: number;
  /** Where the fall ends, as a part of the strength. 0 to 1 */
  fade_level?: number;
  /** Runs between 0 and the strength. */
  waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
  /** 0.5 to 250 */
  frequency_hz?: number;
  /** The part of a period that a square is on. 0.05 to 0.95 */
  on_fraction?: number;
  /** The effect ends after it. Never together with lease_ms. 1 to 10000 */
  duration_ms?: number;
  /** Ends after it unless renewed. 100 to 10000 */
  lease_ms?: number;
  /** "finish" lets an effect of up to 2000 ms play out after the connection ended. */
  on_close?: "stop" | "finish";
  /** The connection's own name for an effect. */
  slot?: string;
  /** Only effects of the highest active priority are output; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of a reduced effect. */
  if_limited?: "reduce" | "refuse";
}

export interface EventsHistoryParams {
  /** Not before this time, RFC 3339. */
  since?: string;
  /** Names of events; default all. */
  types?: Array<string>;
  trips?: boolean;
  /** The newest so many. 1 to 1000 */
  limit?: number;
}

export interface EventsSubscribeParams {
  /** Names of events; default all. */
  types?: Array<string>;
  /** "all" for effects of others too. */
  scope?: "mine" | "all";
}

export type EventsUnsubscribeParams = Record<string, never>;

export interface HelloParams {
  /** Name and version of the client, for the operator. */
  client?: string;
  /** The protocol version of the client. */
  protocol?: string;
  /** Gives the connection the token's role. */
  token?: string;
}

export interface OrientationRecenterParams {
  /** Anticlockwise seen from above. -360 to 360 */
  azimuth_deg?: number;
}

export interface OrientationSetParams {
  /** Device to world, of length 1. */
  quaternion: {
    w: number;
    x: number;
    y: number;
    z: number;
  };
}

export interface OutputSetGainParams {
  /** Multiplies the strength. 0 to 1 */
  gain: number;
}

export interface PatternGetParams {
  /** Of a pattern: vendor/name, or that of a shipped one. */
  name: string;
}

export type PatternListParams = Record<string, never>;

export interface PatternPutParams {
  /** Of a pattern: vendor/name, or that of a shipped one. */
  name: string;
  /** Where and how strongly, at points in time; t_ms never falls. */
  keyframes: Array<{
    t_ms: number;
    direction?: Direction;
    level: number;
    ease?: "linear" | "step" | "smooth";
  }>;
  /** One sentence for whoever chooses a pattern. */
  description?: string;
  /** Runs between 0 and the strength. */
  waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
  /** 0.5 to 250 */
  frequency_hz?: number;
  /** The part of a period that a square is on. 0.05 to 0.95 */
  on_fraction?: number;
}

export interface PatternRemoveParams {
  /** Of a pattern: vendor/name, or that of a shipped one. */
  name: string;
}

export type PingParams = Record<string, never>;

export interface SimSetParams {
  /** Device to world, of length 1. */
  orientation?: {
    w: number;
    x: number;
    y: number;
    z: number;
  };
  /** Temperature of the simulated room. -20 to 60 */
  ambient_c?: number;
  /** Replaces all simulated faults; {} clears them. */
  fault?: {
    faults?: Array<string>;
    coil?: number;
  };
  /** Replaces all errors of measurement and of the ball; [] ends them. */
  errors?: Array<{
    kind: string;
    coil?: number;
    value: number;
    ramp_s?: number;
  }>;
}

export type SimTruthParams = Record<string, never>;

export interface TelemetryHistoryParams {
  /** 1 to 600 */
  seconds?: number;
}

export interface TelemetrySubscribeParams {
  /** 0.1 to 200 */
  rate_hz?: number;
  /** Keys of the status object; default all but pins. */
  fields?: Array<"device" | "simulated" | "time_ns" | "state" | "reason" | "since_s" | "remedy" | "temperature_c" | "limit_a" | "headroom_s" | "burst_s" | "derating" | "current_a" | "duty" | "supply_v" | "field" | "force_n" | "pin" | "fan" | "orientation" | "effects" | "loop" | "link" | "applied_seq" | "last_trip" | "pins">;
}

export type TelemetryUnsubscribeParams = Record<string, never>;

export interface ThermalForecastParams {
  /** Strength as a current; at most limits.current_a. at least 0 */
  current_a?: number;
  /** Where the pins push out. */
  direction?: Direction;
  /** A method that plays. */
  method?: "effect.pulse" | "effect.circle" | "effect.vibrate" | "effect.hold" | "effect.play";
  /** The parameters of that method. */
  params?: object;
  /** The number of an effect, from its admission. 1 to 4294967295 */
  effect?: number;
}

/** Parameters and result of each method, for `ball.call`. */
export interface MethodTypes {
  "connection.list": { params: ConnectionListParams; result: Connections };
  "device.arm": { params: DeviceArmParams; result: State };
  "device.claim": { params: DeviceClaimParams; result: Claim };
  "device.describe": { params: DeviceDescribeParams; result: Description };
  "device.emergency_stop": { params: DeviceEmergencyStopParams; result: State };
  "device.enter_boot_loader": { params: DeviceEnterBootLoaderParams; result: State };
  "device.list": { params: DeviceListParams; result: Devices };
  "device.release": { params: DeviceReleaseParams; result: Done };
  "device.status": { params: DeviceStatusParams; result: Status };
  "effect.circle": { params: EffectCircleParams; result: Admission };
  "effect.hold": { params: EffectHoldParams; result: Admission };
  "effect.latency": { params: EffectLatencyParams; result: Latency };
  "effect.play": { params: EffectPlayParams; result: Admission };
  "effect.preview": { params: EffectPreviewParams; result: Preview };
  "effect.pulse": { params: EffectPulseParams; result: Admission };
  "effect.stop": { params: EffectStopParams; result: Stopped };
  "effect.stop_all": { params: EffectStopAllParams; result: Stopped };
  "effect.update": { params: EffectUpdateParams; result: Admission };
  "effect.vibrate": { params: EffectVibrateParams; result: Admission };
  "events.history": { params: EventsHistoryParams; result: History };
  "events.subscribe": { params: EventsSubscribeParams; result: EventsSubscription };
  "events.unsubscribe": { params: EventsUnsubscribeParams; result: Done };
  "hello": { params: HelloParams; result: Hello };
  "orientation.recenter": { params: OrientationRecenterParams; result: Recentered };
  "orientation.set": { params: OrientationSetParams; result: Done };
  "output.set_gain": { params: OutputSetGainParams; result: Gain };
  "pattern.get": { params: PatternGetParams; result: Pattern };
  "pattern.list": { params: PatternListParams; result: Patterns };
  "pattern.put": { params: PatternPutParams; result: PatternSummary };
  "pattern.remove": { params: PatternRemoveParams; result: Done };
  "ping": { params: PingParams; result: Ping };
  "sim.set": { params: SimSetParams; result: SimulatedWorld };
  "sim.truth": { params: SimTruthParams; result: SimulatedTruth };
  "telemetry.history": { params: TelemetryHistoryParams; result: TelemetryHistory };
  "telemetry.subscribe": { params: TelemetrySubscribeParams; result: TelemetrySubscription };
  "telemetry.unsubscribe": { params: TelemetryUnsubscribeParams; result: Done };
  "thermal.forecast": { params: ThermalForecastParams; result: Forecast };
}

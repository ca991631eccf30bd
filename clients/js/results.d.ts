// SPDX-License-Identifier: MIT
// Written by generate.mjs from protocol/schema/openrpc.json.
// Results, events and errors. A later daemon may send more than they name.

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
  type: "derating_ended" | "derating_started" | "device_attached" | "device_detached" | "effect_ended" | "effect_started" | "orientation_lost" | "orientation_restored" | "overrun" | "shutting_down" | "state_changed" | (string & {});
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
export type EventType = "derating_ended" | "derating_started" | "device_attached" | "device_detached" | "effect_ended" | "effect_started" | "orientation_lost" | "orientation_restored" | "overrun" | "shutting_down" | "state_changed";

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
  /** A bug, or the disk: what was asked is done, but not on disk. */
  readonly internal_error: -32603;
  /** Nothing can be played: state, reason and remedy say why. */
  readonly not_armed: -32000;
  /** Something is full or stopping; nothing was changed. */
  readonly busy: -32001;
  /** It has ended, or is somebody else's. */
  readonly no_such_effect: -32002;
  /** The token is not known. */
  readonly unauthorized: -32003;
  /** It needs role_needed. */
  readonly forbidden: -32004;
  /** There is no board, or no orientation sensor. */
  readonly device_absent: -32005;
  /** Not by this server, not in this configuration. */
  readonly unsupported: -32006;
  /** Heat would make it less than asked, and if_limited is refuse. */
  readonly refused_thermal: -32007;
  /** There is no pattern of that name. */
  readonly no_such_pattern: -32008;
  /** Another client has the ball for itself, or feeds its orientation. */
  readonly claimed: -32009;
  /** It is refused while the ball is armed. */
  readonly armed: -32010;
};
export type ErrorName = keyof typeof ErrorCode;

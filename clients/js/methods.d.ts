// SPDX-License-Identifier: MIT
// Written by generate.mjs from protocol/schema/openrpc.json.
import type {
  Direction, Admission, Claim, Connections, Description, Devices, Done, EventsSubscription, Forecast, Gain, Hello, History, Pattern, PatternSummary, Patterns, Ping, Preview, Recentered, SimulatedTruth, SimulatedWorld, State, Status, Stopped, TelemetryHistory, TelemetrySubscription,
} from "./results.js";

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
  /** Only the highest active one is felt; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of less than what was asked. */
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
  /** Only the highest active one is felt; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of less than what was asked. */
  if_limited?: "reduce" | "refuse";
}

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
  /** Only the highest active one is felt; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of less than what was asked. */
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
  /** Only the highest active one is felt; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of less than what was asked. */
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
  /** Only the highest active one is felt; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of less than what was asked. */
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
  /** Only the highest active one is felt; 8 and 9 need the role operate. 0 to 9 */
  priority?: number;
  /** "refuse": an error instead of less than what was asked. */
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
  /** The version that the client speaks. */
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
  /** Replaces all simulated faults; {} mends the ball. */
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

export declare class Methods {
  /** Who is connected, since when, and what they play. */
  connectionList(params?: ConnectionListParams): Promise<Connections>;
  /** Lets the coils be driven again, when the cause of the stop is gone. */
  arm(params?: DeviceArmParams): Promise<State>;
  /** Only this connection plays until it releases, ends, or is silent. */
  claim(params?: DeviceClaimParams): Promise<Claim>;
  /** The ball: pins, coils, limits, calibration, identity. */
  describe(params?: DeviceDescribeParams): Promise<Description>;
  /** Coils off at the next tick, latched until armed. */
  emergencyStop(params?: DeviceEmergencyStopParams): Promise<State>;
  /** The board goes into its boot loader and waits for new firmware; not while it is armed. */
  enterBootLoader(params?: DeviceEnterBootLoaderParams): Promise<State>;
  /** USB and HID devices: which are used, and why the others are not. */
  list(params?: DeviceListParams): Promise<Devices>;
  /** Gives a claim back. */
  release(params?: DeviceReleaseParams): Promise<Done>;
  /** Everything that can be known of the ball now. */
  status(params?: DeviceStatusParams): Promise<Status>;
  /** The field walks round an axis, from pin to pin. */
  circle(axis?: Direction, params?: Omit<EffectCircleParams, "axis">): Promise<Admission>;
  /** A push that lasts as long as it is renewed. */
  hold(direction: Direction, params?: Omit<EffectHoldParams, "direction">): Promise<Admission>;
  /** Plays key frames, of a named pattern or its own. */
  play(pattern?: string, params?: Omit<EffectPlayParams, "pattern">): Promise<Admission>;
  /** What an effect would do, without doing it. */
  preview(params: EffectPreviewParams): Promise<Preview>;
  /** One push towards a direction. */
  pulse(direction: Direction, params?: Omit<EffectPulseParams, "direction">): Promise<Admission>;
  /** Ends one of the connection's own effects. */
  stop(params?: EffectStopParams): Promise<Stopped>;
  /** Ends all effects of the connection, or of everybody. */
  stopAll(params?: EffectStopAllParams): Promise<Stopped>;
  /** Changes a playing effect and renews its lease. */
  update(params?: EffectUpdateParams): Promise<Admission>;
  /** A push with a waveform. */
  vibrate(direction?: Direction, params?: Omit<EffectVibrateParams, "direction">): Promise<Admission>;
  /** What has happened, also before the last start. */
  eventsHistory(params?: EventsHistoryParams): Promise<History>;
  /** The front of the ball points at this azimuth now. */
  orientationRecenter(params?: OrientationRecenterParams): Promise<Recentered>;
  /** Feeds the orientation from outside. */
  orientationSet(params: OrientationSetParams): Promise<Done>;
  /** The owner's comfort setting for everything, stored. */
  outputSetGain(params: OutputSetGainParams): Promise<Gain>;
  /** One named pattern with its key frames. */
  patternGet(params: PatternGetParams): Promise<Pattern>;
  /** The named patterns there are. */
  patternList(params?: PatternListParams): Promise<Patterns>;
  /** Keeps a pattern under vendor/name. */
  patternPut(params: PatternPutParams): Promise<PatternSummary>;
  /** Forgets a pattern that was put. */
  patternRemove(params: PatternRemoveParams): Promise<Done>;
  /** The device time. */
  ping(params?: PingParams): Promise<Ping>;
  /** Changes the simulated world. */
  simSet(params?: SimSetParams): Promise<SimulatedWorld>;
  /** The simulated ball as it really is. */
  simTruth(params?: SimTruthParams): Promise<SimulatedTruth>;
  /** Temperatures and currents of the last minutes. */
  telemetryHistory(params?: TelemetryHistoryParams): Promise<TelemetryHistory>;
  /** How long a current or an effect can flow. */
  thermalForecast(params?: ThermalForecastParams): Promise<Forecast>;
}

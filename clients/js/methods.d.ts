// SPDX-License-Identifier: MIT
// Written by generate.mjs from protocol/schema/openrpc.json.

/** "left", [0, 1, 0], {azimuth_deg: 90} or {pin: 34}: where the pins push out. */
export type Direction =
  | "up" | "down" | "left" | "right" | "front" | "back"
  | [number, number, number]
  | { azimuth_deg?: number; elevation_deg?: number }
  | { pin: number };

/** A result, as protocol/README.md describes it. */
export type Result = Record<string, any>;

export declare class Methods {
  /** Who is connected, since when, and what they play. */
  connectionList(params?: Record<string, never>): Promise<Result>;
  /** Lets the coils be driven again, when the cause of the stop is gone. */
  arm(params?: Record<string, never>): Promise<Result>;
  /** Only this connection plays until it releases, ends, or is silent. */
  claim(params?: {
    /** Ends after it unless renewed. 100 to 10000 */
    lease_ms?: number;
  }): Promise<Result>;
  /** The ball: pins, coils, limits, calibration, identity. */
  describe(params?: Record<string, never>): Promise<Result>;
  /** Coils off at the next tick, latched until armed. */
  emergencyStop(params?: Record<string, never>): Promise<Result>;
  /** The board goes into its boot loader and waits for new firmware; not while it is armed. */
  enterBootLoader(params?: Record<string, never>): Promise<Result>;
  /** USB and HID devices: which are used, and why the others are not. */
  list(params?: Record<string, never>): Promise<Result>;
  /** Gives a claim back. */
  release(params?: Record<string, never>): Promise<Result>;
  /** Everything that can be known of the ball now. */
  status(params?: Record<string, never>): Promise<Result>;
  /** The field walks round an axis, from pin to pin. */
  circle(axis?: Direction, params?: {
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
  }): Promise<Result>;
  /** A push that lasts as long as it is renewed. */
  hold(direction: Direction, params?: {
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
  }): Promise<Result>;
  /** Plays key frames, of a named pattern or its own. */
  play(pattern?: string, params?: {
    /** Where and how strongly, at points in time; t_ms never falls. */
    keyframes?: Array<object>;
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
  }): Promise<Result>;
  /** What an effect would do, without doing it. */
  preview(params: {
    /** A method that plays. */
    method: "effect.pulse" | "effect.circle" | "effect.vibrate" | "effect.hold" | "effect.play";
    /** The parameters of that method. */
    params: object;
  }): Promise<Result>;
  /** One push towards a direction. */
  pulse(direction: Direction, params?: {
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
  }): Promise<Result>;
  /** Ends one of the connection's own effects. */
  stop(params?: {
    /** The number of an effect, from its admission. 1 to 4294967295 */
    effect?: number;
    /** The connection's own name for an effect. */
    slot?: string;
  }): Promise<Result>;
  /** Ends all effects of the connection, or of everybody. */
  stopAll(params?: {
    /** "all" for effects of others too. */
    scope?: "mine" | "all";
  }): Promise<Result>;
  /** Changes a playing effect and renews its lease. */
  update(params?: {
    /** The number of an effect, from its admission. 1 to 4294967295 */
    effect?: number;
    /** Where the pins push out. */
    direction?: Direction;
    /** The name of a pattern, or keyframes instead. */
    pattern?: string;
    /** Where and how strongly, at points in time; t_ms never falls. */
    keyframes?: Array<object>;
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
  }): Promise<Result>;
  /** A push with a waveform. */
  vibrate(direction?: Direction, params?: {
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
  }): Promise<Result>;
  /** What has happened, also before the last start. */
  eventsHistory(params?: {
    /** Not before this time, RFC 3339. */
    since?: string;
    /** Names of events; default all. */
    types?: Array<string>;
    trips?: boolean;
    /** The newest so many. 1 to 1000 */
    limit?: number;
  }): Promise<Result>;
  /** The front of the ball points at this azimuth now. */
  orientationRecenter(params?: {
    /** Anticlockwise seen from above. -360 to 360 */
    azimuth_deg?: number;
  }): Promise<Result>;
  /** Feeds the orientation from outside. */
  orientationSet(params: {
    /** Device to world, of length 1. */
    quaternion: object;
  }): Promise<Result>;
  /** The owner's comfort setting for everything, stored. */
  outputSetGain(params: {
    /** Multiplies the strength. 0 to 1 */
    gain: number;
  }): Promise<Result>;
  /** One named pattern with its key frames. */
  patternGet(params: {
    /** Of a pattern: vendor/name, or that of a shipped one. */
    name: string;
  }): Promise<Result>;
  /** The named patterns there are. */
  patternList(params?: Record<string, never>): Promise<Result>;
  /** Keeps a pattern under vendor/name. */
  patternPut(params: {
    /** Of a pattern: vendor/name, or that of a shipped one. */
    name: string;
    /** Where and how strongly, at points in time; t_ms never falls. */
    keyframes: Array<object>;
    /** One sentence for whoever chooses a pattern. */
    description?: string;
    /** Runs between 0 and the strength. */
    waveform?: "constant" | "sine" | "square" | "triangle" | "sawtooth" | "noise";
    /** 0.5 to 250 */
    frequency_hz?: number;
    /** The part of a period that a square is on. 0.05 to 0.95 */
    on_fraction?: number;
  }): Promise<Result>;
  /** Forgets a pattern that was put. */
  patternRemove(params: {
    /** Of a pattern: vendor/name, or that of a shipped one. */
    name: string;
  }): Promise<Result>;
  /** The device time. */
  ping(params?: Record<string, never>): Promise<Result>;
  /** Changes the simulated world. */
  simSet(params?: {
    /** Device to world, of length 1. */
    orientation?: object;
    /** Temperature of the simulated room. -20 to 60 */
    ambient_c?: number;
    /** Replaces all simulated faults; {} mends the ball. */
    fault?: object;
    /** Replaces all errors of measurement and of the ball; [] ends them. */
    errors?: Array<object>;
  }): Promise<Result>;
  /** The simulated ball as it really is. */
  simTruth(params?: Record<string, never>): Promise<Result>;
  /** Temperatures and currents of the last minutes. */
  telemetryHistory(params?: {
    /** 1 to 600 */
    seconds?: number;
  }): Promise<Result>;
  /** How long a current or an effect can flow. */
  thermalForecast(params?: {
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
  }): Promise<Result>;
}

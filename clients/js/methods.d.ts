// SPDX-License-Identifier: MIT
// Written by generate.mjs from protocol/schema/openrpc.json.
import type {
  Admission,
  Claim,
  ConnectionListParams,
  Connections,
  Description,
  DeviceArmParams,
  DeviceClaimParams,
  DeviceDescribeParams,
  DeviceEmergencyStopParams,
  DeviceEnterBootLoaderParams,
  DeviceListParams,
  DeviceReleaseParams,
  DeviceStatusParams,
  Devices,
  Direction,
  Done,
  EffectCircleParams,
  EffectHoldParams,
  EffectLatencyParams,
  EffectPlayParams,
  EffectPreviewParams,
  EffectPulseParams,
  EffectStopAllParams,
  EffectStopParams,
  EffectUpdateParams,
  EffectVibrateParams,
  EventsHistoryParams,
  Forecast,
  Gain,
  History,
  Latency,
  OrientationRecenterParams,
  OrientationSetParams,
  OutputSetGainParams,
  Pattern,
  PatternGetParams,
  PatternListParams,
  PatternPutParams,
  PatternRemoveParams,
  PatternSummary,
  Patterns,
  Ping,
  PingParams,
  Preview,
  Recentered,
  SimSetParams,
  SimTruthParams,
  SimulatedTruth,
  SimulatedWorld,
  State,
  Status,
  Stopped,
  TelemetryHistory,
  TelemetryHistoryParams,
  ThermalForecastParams,
} from "./messages.js";

export declare class Methods {
  /** The connections, with their start times and effects. */
  connectionList(params?: ConnectionListParams): Promise<Connections>;
  /** Arms the ball once the cause of the stop no longer exists. */
  arm(params?: DeviceArmParams): Promise<State>;
  /** Exclusive use of the ball until release, end of the connection, or expiry of the lease. */
  claim(params?: DeviceClaimParams): Promise<Claim>;
  /** The ball: pins, coils, limits, calibration, identity. */
  describe(params?: DeviceDescribeParams): Promise<Description>;
  /** Coils off at the next tick, latched until armed. */
  emergencyStop(params?: DeviceEmergencyStopParams): Promise<State>;
  /** Restarts the board in its boot loader, for a firmware update; rejected while armed. */
  enterBootLoader(params?: DeviceEnterBootLoaderParams): Promise<State>;
  /** USB and HID devices: which are used, and why the others are not. */
  list(params?: DeviceListParams): Promise<Devices>;
  /** Releases the claim. */
  release(params?: DeviceReleaseParams): Promise<Done>;
  /** State of the ball: temperatures, currents, limits, effects. */
  status(params?: DeviceStatusParams): Promise<Status>;
  /** The field rotates about an axis, from pin to pin. */
  circle(axis?: Direction, params?: Omit<EffectCircleParams, "axis">): Promise<Admission>;
  /** A push that lasts as long as it is renewed. */
  hold(direction: Direction, params?: Omit<EffectHoldParams, "direction">): Promise<Admission>;
  /** How long effects took from their request to the board. */
  latency(params?: EffectLatencyParams): Promise<Latency>;
  /** Plays key frames, of a named pattern or its own. */
  play(pattern?: string, params?: Omit<EffectPlayParams, "pattern">): Promise<Admission>;
  /** Computes currents and temperatures of an effect without starting it. */
  preview(params: EffectPreviewParams): Promise<Preview>;
  /** One push towards a direction. */
  pulse(direction: Direction, params?: Omit<EffectPulseParams, "direction">): Promise<Admission>;
  /** Ends one of the connection's own effects. */
  stop(params?: EffectStopParams): Promise<Stopped>;
  /** Ends all effects of the connection, or of all connections. */
  stopAll(params?: EffectStopAllParams): Promise<Stopped>;
  /** Changes a playing effect and renews its lease. */
  update(params?: EffectUpdateParams): Promise<Admission>;
  /** A push with a waveform. */
  vibrate(direction?: Direction, params?: Omit<EffectVibrateParams, "direction">): Promise<Admission>;
  /** Past events, including those before the last start. */
  eventsHistory(params?: EventsHistoryParams): Promise<History>;
  /** Sets the azimuth of the ball's front. */
  orientationRecenter(params?: OrientationRecenterParams): Promise<Recentered>;
  /** Sets the orientation measured by an external sensor. */
  orientationSet(params: OrientationSetParams): Promise<Done>;
  /** Gain applied to all effects; persistent. */
  outputSetGain(params: OutputSetGainParams): Promise<Gain>;
  /** One named pattern with its key frames. */
  patternGet(params: PatternGetParams): Promise<Pattern>;
  /** Lists the named patterns. */
  patternList(params?: PatternListParams): Promise<Patterns>;
  /** Stores a pattern under vendor/name. */
  patternPut(params: PatternPutParams): Promise<PatternSummary>;
  /** Removes a stored pattern. */
  patternRemove(params: PatternRemoveParams): Promise<Done>;
  /** The device time. */
  ping(params?: PingParams): Promise<Ping>;
  /** Sets orientation, ambient temperature and faults of the simulation. */
  simSet(params?: SimSetParams): Promise<SimulatedWorld>;
  /** True state of the simulated ball. */
  simTruth(params?: SimTruthParams): Promise<SimulatedTruth>;
  /** Temperatures and currents of the last minutes. */
  telemetryHistory(params?: TelemetryHistoryParams): Promise<TelemetryHistory>;
  /** How long a current or an effect can flow. */
  thermalForecast(params?: ThermalForecastParams): Promise<Forecast>;
}

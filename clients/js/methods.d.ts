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
  /** How long effects took from their request to the board. */
  latency(params?: EffectLatencyParams): Promise<Latency>;
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

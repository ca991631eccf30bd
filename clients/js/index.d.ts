// SPDX-License-Identifier: MIT
import type { BallEvent, Direction, ErrorData, ErrorName, EventType, Hello, MethodTypes, Telemetry } from "./messages.js";
import { Methods } from "./methods.js";

export * from "./messages.js";

export interface Options {
  /** "127.0.0.1:7586", "tls://host:7586", "mdns://ball-7" or a socket's path in Node.js, "ws://..." in a browser; without, found as by every client. */
  address?: string;
  /** Of this program, as the daemon's log shows it. */
  name?: string;
  /** The longest that connecting, and waiting for a response, take. 2000. */
  timeoutMs?: number;
  /** Of roles beyond those of this machine; in Node.js else HEDGEHOG_TOKEN. */
  token?: string;
  /** In Node.js, of the daemon's certificate with "tls://" and "mdns://"; else HEDGEHOG_FINGERPRINT. */
  fingerprint?: string;
  /** Called after each connection but the first: subscriptions are renewed, effects are not. */
  onReconnect?: (hello: Hello) => void;
  /** Called when the daemon of a new connection refuses a subscription, which has ended. */
  onSubscriptionEnded?: (error: SubscriptionEnded) => void;
}

/** A key of the status, for telemetry. */
export type TelemetryField = NonNullable<MethodTypes["telemetry.subscribe"]["params"]["fields"]>[number];
export type Scope = NonNullable<MethodTypes["events.subscribe"]["params"]["scope"]>;
export type VibrateParams = Omit<MethodTypes["effect.vibrate"]["params"], "direction" | "slot" | "level">;

export declare class BallError extends Error {}
export declare class AddressError extends BallError {}
export declare class NotConnected extends BallError {
  readonly retryAfterMs: number;
}
export declare class RequestError extends BallError {
  /** One of ErrorCode, or one that a later daemon has. */
  readonly code: number;
  /** "invalid_params"; "" when the daemon gave none. */
  readonly reason: ErrorName | (string & {});
  readonly data: Partial<ErrorData>;
}
/** The message begins with the method. */
export declare class SubscriptionEnded extends RequestError {
  /** "events.subscribe" */
  readonly method: string;
}

/** A ball that has announced itself, at one of its addresses. */
export interface DiscoveredBall {
  name: string;
  host: string;
  /** Of its host, in digits. */
  address: string;
  port: number;
  /** null: it announces none. */
  serial: string | null;
  protocol: string | null;
  /** What it announces; the daemon always does. */
  tls: boolean;
}
/** Only in Node.js: the balls on the network that answer within that time, 1000, by name. Takes the whole time. */
export declare function discover(timeoutMs?: number): Promise<DiscoveredBall[]>;

export declare class Ball extends Methods {
  static connect(options?: Options): Promise<Ball>;
  constructor(options?: Options);
  readonly connected: boolean;
  readonly hello: Hello | null;
  open(): Promise<void>;
  close(): void;
  call<M extends keyof MethodTypes>(method: M, params?: MethodTypes[M]["params"]): Promise<MethodTypes[M]["result"]>;
  /** Of a method that these types do not know. */
  call(method: string, params?: object): Promise<unknown>;
  notify<M extends keyof MethodTypes>(method: M, params?: MethodTypes[M]["params"]): boolean;
  notify(method: string, params?: object): boolean;
  rumble(slot: string, strength: number, direction?: Direction, params?: VibrateParams): boolean;
  events(types?: EventType[], options?: { scope?: Scope }): AsyncIterableIterator<BallEvent>;
  telemetry(rate_hz?: number, fields?: TelemetryField[]): AsyncIterableIterator<Telemetry>;
  notifications(): AsyncIterableIterator<["event", BallEvent] | ["telemetry", Telemetry]>;
}

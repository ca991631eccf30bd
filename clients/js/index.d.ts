// SPDX-License-Identifier: MIT
import { Methods, Direction, Result } from "./methods.js";

export { Direction, Result } from "./methods.js";

export interface Options {
  /** "127.0.0.1:7586" or a socket's path in Node.js, "ws://..." in a browser; without, found as by every client. */
  address?: string;
  /** Of this program, as the daemon's log shows it. */
  name?: string;
  /** The longest that connecting, and waiting for a response, take. 2000. */
  patienceMs?: number;
  /** Of roles beyond those of this machine. */
  token?: string;
}

export declare class BallError extends Error {}
export declare class AddressError extends BallError {}
export declare class NotConnected extends BallError {
  readonly retryAfterMs: number;
}
export declare class RequestError extends BallError {
  readonly code: number;
  /** "invalid_params" */
  readonly reason: string;
  readonly data: Record<string, unknown>;
}

export declare class Ball extends Methods {
  static connect(options?: Options): Promise<Ball>;
  constructor(options?: Options);
  readonly connected: boolean;
  readonly hello: Result | null;
  open(): Promise<void>;
  close(): void;
  call(method: string, params?: object): Promise<any>;
  notify(method: string, params?: object): boolean;
  rumble(slot: string, strength: number, direction?: Direction, params?: object): boolean;
  events(types?: string[], options?: { scope?: string }): AsyncGenerator<Result>;
  telemetry(rate_hz?: number, fields?: string[]): AsyncGenerator<Result>;
  notifications(): AsyncIterableIterator<[string, Result]>;
}

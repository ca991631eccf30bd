// SPDX-License-Identifier: MIT
// Written by generate.mjs from protocol/schema/openrpc.json.

/** Codes of RequestError, by name. */
export const ErrorCode = Object.freeze({
  /** The line is not JSON. */
  parse_error: -32700,
  /** JSON, but no request. */
  invalid_request: -32600,
  /** There is no such method. */
  method_not_found: -32601,
  /** A parameter is unknown, missing, of the wrong type, out of range, or at odds with another. */
  invalid_params: -32602,
  /** A bug; or the request was applied, but not written to disk. */
  internal_error: -32603,
  /** Nothing can be played: state, reason and remedy say why. */
  not_armed: -32000,
  /** A queue or pool is full, or the daemon is stopping; nothing was changed. */
  busy: -32001,
  /** The effect has ended, or belongs to another connection. */
  no_such_effect: -32002,
  /** The token is unknown or revoked. */
  unauthorized: -32003,
  /** It needs role_needed. */
  forbidden: -32004,
  /** There is no board, or no orientation sensor. */
  device_absent: -32005,
  /** Not by this server, not in this configuration. */
  unsupported: -32006,
  /** The thermal limit would reduce the effect, and if_limited is refuse. */
  refused_thermal: -32007,
  /** There is no pattern of that name. */
  no_such_pattern: -32008,
  /** Another client has exclusive use of the ball, or sets its orientation. */
  claimed: -32009,
  /** It is refused while the ball is armed. */
  armed: -32010,
});

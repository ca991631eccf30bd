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
  /** A bug, or the disk: what was asked is done, but not on disk. */
  internal_error: -32603,
  /** Nothing can be played: state, reason and remedy say why. */
  not_armed: -32000,
  /** Something is full or stopping; nothing was changed. */
  busy: -32001,
  /** It has ended, or is somebody else's. */
  no_such_effect: -32002,
  /** The token is not known. */
  unauthorized: -32003,
  /** It needs role_needed. */
  forbidden: -32004,
  /** There is no board, or no orientation sensor. */
  device_absent: -32005,
  /** Not by this server, not in this configuration. */
  unsupported: -32006,
  /** Heat would make it less than asked, and if_limited is refuse. */
  refused_thermal: -32007,
  /** There is no pattern of that name. */
  no_such_pattern: -32008,
  /** Another client has the ball for itself, or feeds its orientation. */
  claimed: -32009,
  /** It is refused while the ball is armed. */
  armed: -32010,
});

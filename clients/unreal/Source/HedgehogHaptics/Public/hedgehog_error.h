// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
// Why the daemon refuses a request.
#pragma once

#include "CoreMinimal.h"

#include "hedgehog_error.generated.h"

UENUM(BlueprintType)
enum class EHedgehogError : uint8 {
  None,
  /// The line is not JSON.
  ParseError,
  /// JSON, but no request.
  InvalidRequest,
  /// There is no such method.
  MethodNotFound,
  /// A parameter is unknown, missing, of the wrong type, out of range, or at odds with another.
  InvalidParams,
  /// A bug; or the request was applied, but not written to disk.
  InternalError,
  /// Nothing can be played: state, reason and remedy say why.
  NotArmed,
  /// A queue or pool is full, or the daemon is stopping; nothing was changed.
  Busy,
  /// The effect has ended, or belongs to another connection.
  NoSuchEffect,
  /// The token is unknown or revoked.
  Unauthorized,
  /// It needs role_needed.
  Forbidden,
  /// There is no board, or no orientation sensor.
  DeviceAbsent,
  /// Not by this server, not in this configuration.
  Unsupported,
  /// The thermal limit would reduce the effect, and if_limited is refuse.
  RefusedThermal,
  /// There is no pattern of that name.
  NoSuchPattern,
  /// Another client has exclusive use of the ball, or sets its orientation.
  Claimed,
  /// It is refused while the ball is armed.
  Armed,
  /// One that a later daemon has.
  Other,
};

/// Of an answer's Code; 0: None.
inline EHedgehogError HedgehogErrorOf(int32 Code) {
  switch (Code) {
    case 0: return EHedgehogError::None;
    case -32700: return EHedgehogError::ParseError;
    case -32600: return EHedgehogError::InvalidRequest;
    case -32601: return EHedgehogError::MethodNotFound;
    case -32602: return EHedgehogError::InvalidParams;
    case -32603: return EHedgehogError::InternalError;
    case -32000: return EHedgehogError::NotArmed;
    case -32001: return EHedgehogError::Busy;
    case -32002: return EHedgehogError::NoSuchEffect;
    case -32003: return EHedgehogError::Unauthorized;
    case -32004: return EHedgehogError::Forbidden;
    case -32005: return EHedgehogError::DeviceAbsent;
    case -32006: return EHedgehogError::Unsupported;
    case -32007: return EHedgehogError::RefusedThermal;
    case -32008: return EHedgehogError::NoSuchPattern;
    case -32009: return EHedgehogError::Claimed;
    case -32010: return EHedgehogError::Armed;
    default: return EHedgehogError::Other;
  }
}

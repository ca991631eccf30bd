// SPDX-License-Identifier: MIT
// JSON-RPC error objects as values (protocol/README.md).
#pragma once

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "protocol/wire/role.h"

namespace hedgehog::protocol {

enum class ErrorCode : int {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,
  kNotArmed = -32000,
  kBusy = -32001,
  kNoSuchEffect = -32002,
  kUnauthorized = -32003,
  kForbidden = -32004,
  kDeviceAbsent = -32005,
  kUnsupported = -32006,
  kRefusedThermal = -32007,
  kNoSuchPattern = -32008,
  kClaimed = -32009,
  kArmed = -32010,
};

/// `data.name` of the code: "invalid_params", "not_armed", ...; "server_error" for any other code.
std::string_view name(ErrorCode code) noexcept;

/// A value in `data`: the requested one, or the limit.
using ErrorValue = std::variant<bool, std::int64_t, double, std::string>;

/// `message` is one human-readable sentence; the optional fields go to `data` where they apply.
struct RpcError {
  ErrorCode code = ErrorCode::kInternalError;
  std::string message;
  /// The invalid parameter, its limit and its value.
  std::optional<std::string> field{};
  std::optional<ErrorValue> limit{};
  std::optional<ErrorValue> value{};
  /// Required role: `forbidden`, `unauthorized`, `not_armed`.
  std::optional<Role> role_needed{};
  /// The ball's state, its reason and the remedy: `not_armed`, `armed`, `device_absent`.
  std::optional<std::string> state{};
  std::optional<std::string> reason{};
  std::optional<std::string> remedy{};
  /// Time after which a retry may succeed: `busy`, `refused_thermal`, `claimed`.
  std::optional<std::int64_t> retry_after_ms{};
  /// `device_absent`: "board" or "imu".
  std::optional<std::string> device{};
  /// `refused_thermal`: the current allowed now.
  std::optional<double> limit_a{};

  friend bool operator==(const RpcError&, const RpcError&) = default;
};

/// Makes `result<T>::value()` throw std::runtime_error with the message.
[[noreturn]] void throw_exception_from_error(const RpcError& error,
                                             const boost::source_location& where);

template <class T>
using Result = boost::system::result<T, RpcError>;

/// "level: 1.4 is above 1" or "... is below ...", with field, limit and value.
RpcError out_of_range(std::string_view field, double limit, double value);
/// -32602 "<field>: <what>", for any other invalid parameter.
RpcError invalid_params(std::string_view field, std::string_view what);
/// "scope: all needs the role operate, you have play". `what` is the parameter or method concerned.
RpcError forbidden(std::string_view field, std::string_view what, Role needed, Role has);
/// "effect: you play no effect 41".
RpcError no_such_effect(std::int64_t effect);
/// "slot: you play no effect in 'engine'".
RpcError no_such_slot(std::string_view slot);
/// "busy: <what>"
RpcError busy(std::string_view what, std::int64_t retry_after_ms);
/// "not_armed: <state> by <reason>. <remedy>"
RpcError not_armed(std::string_view state, std::string_view reason, std::string_view remedy);
/// "armed: <what>. <remedy>"
RpcError armed(std::string_view what, std::string_view remedy);
/// "<field>: <what>"; `device` is "board" or "imu".
RpcError device_absent(std::string_view field, std::string_view what, std::string_view device);
/// Any of the codes above with its message.
RpcError error(ErrorCode code, std::string message);

}  // namespace hedgehog::protocol

// SPDX-License-Identifier: MIT
#include "protocol/wire/error.h"

#include <boost/throw_exception.hpp>
#include <cmath>
#include <stdexcept>

#include "protocol/wire/json.h"

namespace hedgehog::protocol {
namespace {

ErrorValue number(double value) {
  constexpr double kExact = 9'007'199'254'740'992.0;
  if (std::fabs(value) < kExact && value == std::trunc(value))
    return static_cast<std::int64_t>(value);
  return value;
}

std::string text(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

std::string join(std::initializer_list<std::string_view> parts) {
  std::string out;
  for (const std::string_view part : parts) out += part;
  return out;
}

}  // namespace

std::string_view name(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kParseError:
      return "parse_error";
    case ErrorCode::kInvalidRequest:
      return "invalid_request";
    case ErrorCode::kMethodNotFound:
      return "method_not_found";
    case ErrorCode::kInvalidParams:
      return "invalid_params";
    case ErrorCode::kInternalError:
      return "internal_error";
    case ErrorCode::kNotArmed:
      return "not_armed";
    case ErrorCode::kBusy:
      return "busy";
    case ErrorCode::kNoSuchEffect:
      return "no_such_effect";
    case ErrorCode::kUnauthorized:
      return "unauthorized";
    case ErrorCode::kForbidden:
      return "forbidden";
    case ErrorCode::kDeviceAbsent:
      return "device_absent";
    case ErrorCode::kUnsupported:
      return "unsupported";
    case ErrorCode::kRefusedThermal:
      return "refused_thermal";
    case ErrorCode::kNoSuchPattern:
      return "no_such_pattern";
    case ErrorCode::kClaimed:
      return "claimed";
    case ErrorCode::kArmed:
      return "armed";
  }
  return "server_error";
}

void throw_exception_from_error(const RpcError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.message), where);
}

RpcError error(ErrorCode code, std::string message) {
  return {.code = code, .message = std::move(message)};
}

RpcError invalid_params(std::string_view field, std::string_view what) {
  RpcError made = error(ErrorCode::kInvalidParams, join({field, ": ", what}));
  made.field = field;
  return made;
}

RpcError out_of_range(std::string_view field, double limit, double value) {
  const std::string_view side = value > limit ? " is above " : " is below ";
  RpcError made = invalid_params(field, text(value) + std::string(side) + text(limit));
  made.limit = number(limit);
  made.value = number(value);
  return made;
}

RpcError forbidden(std::string_view field, std::string_view what, Role needed, Role has) {
  RpcError made =
      error(ErrorCode::kForbidden,
            join({field, ": ", what, " needs the role ", name(needed), ", you have ", name(has)}));
  made.field = field;
  made.role_needed = needed;
  return made;
}

RpcError no_such_effect(std::int64_t effect) {
  RpcError made =
      error(ErrorCode::kNoSuchEffect, "effect: you play no effect " + std::to_string(effect));
  made.field = "effect";
  made.value = effect;
  return made;
}

RpcError no_such_slot(std::string_view slot) {
  RpcError made =
      error(ErrorCode::kNoSuchEffect, join({"slot: you play no effect in '", slot, "'"}));
  made.field = "slot";
  made.value = std::string(slot);
  return made;
}

RpcError busy(std::string_view what, std::int64_t retry_after_ms) {
  RpcError made = error(ErrorCode::kBusy, join({"busy: ", what}));
  made.retry_after_ms = retry_after_ms;
  return made;
}

RpcError not_armed(std::string_view state, std::string_view reason, std::string_view remedy) {
  std::string message = join({"not_armed: the ball is ", state});
  if (!reason.empty()) message += join({" (", reason, ")"});
  if (!remedy.empty()) message += join({". ", remedy});
  RpcError made = error(ErrorCode::kNotArmed, std::move(message));
  made.state = state;
  if (!reason.empty()) made.reason = reason;
  if (!remedy.empty()) made.remedy = remedy;
  made.role_needed = Role::kOperate;
  return made;
}

RpcError armed(std::string_view what, std::string_view remedy) {
  RpcError made = error(ErrorCode::kArmed, join({"armed: ", what, ". ", remedy}));
  made.state = "armed";
  made.remedy = remedy;
  return made;
}

RpcError device_absent(std::string_view field, std::string_view what, std::string_view device) {
  RpcError made = error(ErrorCode::kDeviceAbsent, join({field, ": ", what}));
  made.field = field;
  made.device = device;
  return made;
}

}  // namespace hedgehog::protocol

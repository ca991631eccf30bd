// SPDX-License-Identifier: MIT
// Outcome of a request.
#pragma once

#include <functional>
#include <string>

#include "core/json.h"

namespace hedgehog::unreal {

enum class Failure {
  kNone,
  kRefused,       // error response of the daemon: see code, name and data
  kNotConnected,  // no listener, or the connection has ended
  kBadAddress,    // the given address of the daemon is invalid
  kBadValue,      // a number that JSON cannot represent
};

struct Answer {
  Failure failure = Failure::kNone;
  /// Result of a success.
  Json result{};
  /// The error, one sentence for users.
  std::string message{};
  /// Of a refusal: the protocol's error code and name, and data.field, data.limit, data.value.
  int code = 0;
  std::string name{};
  Json data{};
  /// kNotConnected: time until the next attempt.
  double retry_after_s = 0.0;

  bool ok() const { return failure == Failure::kNone; }
};

using OnAnswer = std::function<void(const Answer&)>;

/// From JSON-RPC's error object.
Answer refusal_of(const Json& error);
Answer failed(Failure failure, std::string message, double retry_after_s = 0.0);

}  // namespace hedgehog::unreal

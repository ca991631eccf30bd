// SPDX-License-Identifier: MIT
// What came of a request.
#pragma once

#include <functional>
#include <string>

#include "core/json.h"

namespace hedgehog::unreal {

enum class Failure {
  kNone,
  kRefused,       // the daemon refuses: see code, name and data
  kNotConnected,  // nobody answers, or the connection has ended
  kBadAddress,    // what was given as the daemon's address is none
  kBadValue,      // a number that JSON has not
};

struct Answer {
  Failure failure = Failure::kNone;
  /// Of a success.
  Json result{};
  /// Why not, one sentence for people.
  std::string message{};
  /// Of a refusal: the protocol's number and name, and data.field, data.limit, data.value.
  int code = 0;
  std::string name{};
  Json data{};
  /// kNotConnected: the next attempt is so far away.
  double retry_after_s = 0.0;

  bool ok() const { return failure == Failure::kNone; }
};

using OnAnswer = std::function<void(const Answer&)>;

/// Of JSON-RPC's error object.
Answer refusal_of(const Json& error);
Answer failed(Failure failure, std::string message, double retry_after_s = 0.0);

}  // namespace hedgehog::unreal

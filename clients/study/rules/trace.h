// SPDX-License-Identifier: MIT
// Trace of a staircase for a given string of responses.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "clients/study/rules/staircase.h"

namespace hedgehog::study {

struct Trace {
  /// The level of each token: 0 for a catch trial, the repeated level for a void one.
  std::vector<Level> levels{};
  /// The effect of each scored token.
  std::vector<Step> steps{};
  std::vector<Level> reversals{};
  /// Decimal text rounded to 12 places; nullopt unless finished.
  std::optional<std::string> threshold{};
  Status status = Status::kIncomplete;
  int scored = 0;
  int catches = 0;
  int false_alarms = 0;
  int voids = 0;
  int floor_hits = 0;
  int ceiling_hits = 0;
  /// Tokens after the end.
  int unused = 0;
};

/// Processes one token at a time, so that it can be stopped and copied at any point. Tokens: `1`
/// `0` scored positive, negative; `Y` `N` catch trial answered yes, no; `T` void.
class Tracer {
 public:
  explicit Tracer(const Experiment& experiment);
  /// False: not a token, or not valid for this experiment (catch trials belong to yes/no tasks).
  bool take(char token);
  Trace result() const;

 private:
  Experiment experiment_;
  Staircase staircase_;
  Trace trace_;
};

/// The trace, or one sentence about the first invalid token.
std::variant<Trace, std::string> trace(const Experiment& experiment, std::string_view tokens);

}  // namespace hedgehog::study

// SPDX-License-Identifier: MIT
// A string of answers put through a staircase, to see what it does.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "clients/study/rules/staircase.h"

namespace hedgehog::study {

struct Trace {
  /// What each token was presented at: 0 for a catch trial, the repeated level for a void one.
  std::vector<Level> levels{};
  /// What each scored token did.
  std::vector<Step> steps{};
  std::vector<Level> reversals{};
  /// Decimal text rounded to 12 places; nothing unless finished.
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

/// One after another, so that it can be stopped and copied anywhere. Tokens: `1` `0` scored
/// positive, negative; `Y` `N` catch trial answered yes, no; `T` void.
class Tracer {
 public:
  explicit Tracer(const Experiment& experiment);
  /// False: not a token, or none of this experiment (catch trials belong to yes/no tasks).
  bool take(char token);
  Trace result() const;

 private:
  Experiment experiment_;
  Staircase staircase_;
  Trace so_far_;
};

/// Or one sentence naming the token that is none.
std::variant<Trace, std::string> trace(const Experiment& experiment, std::string_view tokens);

}  // namespace hedgehog::study

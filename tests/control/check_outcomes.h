// SPDX-License-Identifier: MIT
// Results of a check for readings that drift, jump, stop and resume, as a row of figures.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "daemon/control/state/state.h"
#include "model/random_stream.h"
#include "model/tick.h"
#include "tests/rig/reference_record.h"

namespace hedgehog::control {

inline constexpr int kReferenceRows = 24;
inline constexpr int kReferenceTicks = 600;
inline constexpr double kReferenceDtS = model::kTickSeconds;

/// A row: aggregated results of a number of ticks.
class Outcomes {
 public:
  void add(Reason reason, Reason blocker = Reason::kNone) {
    ++tick_;
    found_ += weight() * static_cast<double>(reason);
    blockers_ += weight() * static_cast<double>(blocker);
    if (reason == Reason::kNone || first_ > 0) return;
    first_ = tick_;
    first_reason_ = reason;
  }
  void add(const std::string& name, double value) {
    for (auto& [known, sum] : sums_) {
      if (known != name) continue;
      sum += weight() * value;
      return;
    }
    sums_.emplace_back(name, weight() * value);
  }
  rig::ReferenceRecord::Figures figures() const {
    rig::ReferenceRecord::Figures all{{"first", first_},
                                      {"reason", static_cast<double>(first_reason_)},
                                      {"reasons", found_},
                                      {"blockers", blockers_}};
    all.insert(all.end(), sums_.begin(), sums_.end());
    return all;
  }

 private:
  /// Weighted by time, so that swapped ticks are detected.
  double weight() const { return 1.0 + 0.01 * tick_; }

  int tick_ = 0;
  int first_ = 0;
  Reason first_reason_ = Reason::kNone;
  double found_ = 0.0;
  double blockers_ = 0.0;
  rig::ReferenceRecord::Figures sums_;
};

/// One of `choices`, at random.
template <class... Choices>
double one_of(model::RandomStream& random, Choices... choices) {
  const std::array<double, sizeof...(Choices)> all{static_cast<double>(choices)...};
  return all[random.bits() % all.size()];
}

inline bool bernoulli(model::RandomStream& random, double share) {
  return random.uniform(0.0, 1.0) < share;
}

}  // namespace hedgehog::control

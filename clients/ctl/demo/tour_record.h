// SPDX-License-Identifier: MIT
// What the daemon said while the tour played: the figures of the summary, and whether the tour may
// be called a success.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/values/event.h"
#include "protocol/values/status.h"

namespace hedgehog::client {

/// One thread. Every number in it came from the daemon.
class TourRecord {
 public:
  void take(const protocol::Status& status);
  void take(const protocol::Event& event);
  /// A request of the tour was refused.
  void refused(const std::string& message) { failures_.push_back(message); }

  /// The pins that the field pointed at since the last call, each once in a row.
  std::vector<std::int64_t> take_pins();
  /// The current of the strongest push since the last call, A; nothing when no status came. It is
  /// the mean of the statuses within a tenth of the largest, which alone would add its own noise.
  std::optional<double> take_current_a();
  /// The most pins that were felt at once since the last call. Not those of the strongest status:
  /// in a vibration the current still flows when the push of this tick is over.
  long take_max_felt();

  double hottest_c() const noexcept { return hottest_c_; }
  double min_limit_a() const noexcept { return min_limit_a_; }
  /// What went wrong, a line each; empty: all is well. `last` is the status after the end,
  /// `began_ns` when the tour began, by the ball's clock: what tripped earlier is none of it.
  /// `starts_warm`: the long push must have been derated; a cold ball need not.
  std::vector<std::string> failures(const protocol::Status& last, std::int64_t began_ns,
                                    bool starts_warm) const;

 private:
  double hottest_c_ = 0.0;
  double min_limit_a_ = 1e9;
  std::vector<std::int64_t> pins_;
  std::vector<double> currents_a_;
  long max_felt_ = 0;
  std::vector<std::string> failures_;
};

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// Status and events during the tour: the figures of the summary, and whether the tour succeeded.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/values/event.h"
#include "protocol/values/status.h"

namespace hedgehog::client {

/// One thread. All values are the daemon's.
class TourRecord {
 public:
  void take(const protocol::Status& status);
  void take(const protocol::Event& event);
  /// A request of the tour was refused.
  void refused(const std::string& message) { failures_.push_back(message); }

  /// The pins that the field pointed at since the last call, without consecutive duplicates.
  std::vector<std::int64_t> take_pins();
  /// The current of the strongest push since the last call, A; nullopt without a status. It is the
  /// mean of the statuses within a tenth of the maximum; the maximum alone would be biased by its
  /// noise.
  std::optional<double> take_current_a();
  /// The maximum number of pins felt at once since the last call. Not those of the strongest
  /// status: in a vibration the current still flows when the push of this tick is over.
  long take_max_felt();

  double hottest_c() const noexcept { return hottest_c_; }
  double min_limit_a() const noexcept { return min_limit_a_; }
  /// Failures, a line each; empty: success. `last` is the status after the end, `began_ns` the
  /// start in device time: earlier trips are ignored. `starts_warm`: the long push must have been
  /// derated, which a cold ball does not need.
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

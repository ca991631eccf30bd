// SPDX-License-Identifier: MIT
// Tick rate and lateness of a loop, aggregated for the status.
#pragma once

#include <cstdint>

#include "daemon/control/loop/lateness.h"
#include "daemon/control/snapshot.h"

namespace hedgehog::control {

/// Control thread. Real-time safe.
class LoopMeter {
 public:
  explicit LoopMeter(std::int64_t now_ns) noexcept : summed_ns_(now_ns) {}

  /// Adds the execution time of a tick, ns.
  void worked(std::int64_t ns) noexcept { statistics_.work.add(ns); }

  /// The loop woke at `woke_ns`, `late_ns` after its due time.
  void woke(std::int64_t woke_ns, std::int64_t late_ns) noexcept {
    lateness_.add(late_ns);
    statistics_.lateness.add(late_ns);
    if (woke_ns - summed_ns_ >= period_ns_) sum(woke_ns);
  }
  void ticked(std::uint32_t skipped) noexcept {
    ++statistics_.ticks;
    statistics_.skipped += skipped;
  }

  const LoopStatistics& statistics() const noexcept { return statistics_; }

 private:
  // The first period is short, so that a status right after the start contains a rate.
  static constexpr std::int64_t kFirstNs = 100'000'000;
  static constexpr std::int64_t kPeriodNs = 1'000'000'000;

  void sum(std::int64_t now_ns) noexcept {
    const Lateness::Summary late = lateness_.summary();
    statistics_.lateness_p50_us = late.p50_us;
    statistics_.lateness_p99_us = late.p99_us;
    statistics_.lateness_max_us = late.max_us;
    statistics_.rate_hz = static_cast<double>(statistics_.ticks - summed_ticks_) * 1e9 /
                          static_cast<double>(now_ns - summed_ns_);
    summed_ns_ = now_ns;
    summed_ticks_ = statistics_.ticks;
    period_ns_ = kPeriodNs;
  }

  Lateness lateness_;
  LoopStatistics statistics_;
  std::int64_t period_ns_ = kFirstNs;
  std::int64_t summed_ns_;
  std::uint64_t summed_ticks_ = 0;
};

}  // namespace hedgehog::control

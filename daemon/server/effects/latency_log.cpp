// SPDX-License-Identifier: MIT
#include "daemon/server/effects/latency_log.h"

#include <algorithm>

namespace hedgehog::server {

void LatencyLog::add(const control::EffectTimes& times) {
  const Durations durations{times.queued_ns - times.received_ns, times.applied_ns - times.queued_ns,
                            times.written_ns - times.applied_ns,
                            times.written_ns - times.received_ns};
  for (std::size_t i = 0; i < durations.size(); ++i) histograms_[i].add(durations[i]);
  if (newest_.size() < kNewest) {
    newest_.push_back(durations);
  } else {
    newest_[oldest_] = durations;
    oldest_ = (oldest_ + 1) % kNewest;
  }
}

LatencyLog::Quantiles LatencyLog::quantiles(LatencyStage stage) const {
  std::vector<std::int64_t> sorted(newest_.size());
  std::transform(newest_.begin(), newest_.end(), sorted.begin(), [&](const Durations& durations) {
    return durations[static_cast<std::size_t>(stage)];
  });
  std::sort(sorted.begin(), sorted.end());
  // Nearest-rank percentile.
  const auto at = [&](std::size_t percent) {
    return static_cast<double>(sorted[(percent * sorted.size() + 99) / 100 - 1]) * 1e-3;
  };
  return {at(50), at(99), at(100)};
}

}  // namespace hedgehog::server

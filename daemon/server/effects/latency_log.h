// SPDX-License-Identifier: MIT
// Latency of effects from their request to the first frame with their set-point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/histogram.h"
#include "daemon/control/effects/effect_times.h"

namespace hedgehog::server {

/// Sections between the stages of control::EffectTimes.
enum class LatencyStage : std::uint8_t {
  kReceivedToQueued,
  kQueuedToApplied,
  kAppliedToWritten,
  kReceivedToWritten,
};
inline constexpr std::array<std::string_view, 4> kLatencyStageNames{
    "received_to_queued", "queued_to_applied", "applied_to_written", "received_to_written"};

/// io thread only.
class LatencyLog {
 public:
  /// Number of newest effects in the quantiles.
  static constexpr std::size_t kNewest = 1024;

  struct Quantiles {
    double p50_us = 0.0;
    double p99_us = 0.0;
    double max_us = 0.0;
  };

  void add(const control::EffectTimes& times);

  /// Number of effects in the quantiles.
  std::size_t effects() const noexcept { return newest_.size(); }
  /// REQUIRES: effects() > 0.
  Quantiles quantiles(LatencyStage stage) const;
  /// Of all effects since the start.
  const base::Histogram& histogram(LatencyStage stage) const noexcept {
    return histograms_[static_cast<std::size_t>(stage)];
  }

 private:
  using Durations = std::array<std::int64_t, kLatencyStageNames.size()>;  // ns

  std::vector<Durations> newest_;
  std::size_t oldest_ = 0;  // valid once there are kNewest
  std::array<base::Histogram, kLatencyStageNames.size()> histograms_{};
};

}  // namespace hedgehog::server

// SPDX-License-Identifier: MIT
// Lateness of ticks: p50, p99 and the maximum, without allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace hedgehog::control {

/// Control thread. All counts are halved every 10 000 ticks; the maximum is that of the whole run.
class Lateness {
 public:
  struct Summary {
    double p50_us = 0.0;
    double p99_us = 0.0;
    double max_us = 0.0;
  };

  /// Real-time safe.
  void add(std::int64_t late_ns) noexcept {
    late_ns = std::max<std::int64_t>(late_ns, 0);
    const auto bucket = std::min<std::size_t>(static_cast<std::size_t>(late_ns / 1000), kLast);
    ++counts_[bucket];
    max_ns_ = std::max(max_ns_, late_ns);
    if (++total_ < kHalveAt) return;
    total_ = 0;
    for (std::uint32_t& count : counts_) total_ += (count /= 2);
  }

  /// Real-time safe, but iterates over 1024 numbers: not for every tick. Lateness beyond a
  /// millisecond counts as the maximum.
  Summary summary() const noexcept {
    return {quantile(total_ / 2), quantile(total_ - total_ / 100),
            static_cast<double>(max_ns_) * 1e-3};
  }

 private:
  static constexpr std::size_t kLast = 1023;
  static constexpr std::uint32_t kHalveAt = 20'000;

  double quantile(std::uint32_t rank) const noexcept {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < kLast; ++i) {
      sum += counts_[i];
      if (sum > 0 && sum >= rank) return static_cast<double>(i + 1);
    }
    return total_ == 0 ? 0.0 : static_cast<double>(max_ns_) * 1e-3;
  }

  std::array<std::uint32_t, kLast + 1> counts_{};
  std::uint32_t total_ = 0;
  std::int64_t max_ns_ = 0;
};

}  // namespace hedgehog::control

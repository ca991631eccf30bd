// SPDX-License-Identifier: MIT
// Cumulative histogram of durations since the start. Never reset, so that readers can take
// differences; trivially copyable.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hedgehog::base {

struct Histogram {
  /// Upper bounds of the buckets, ns; the last bucket has none.
  static constexpr std::array<std::int64_t, 14> kBoundsNs{
      1'000,   2'000,   5'000,     10'000,    20'000,    50'000,     100'000,
      200'000, 500'000, 1'000'000, 2'000'000, 5'000'000, 10'000'000, 20'000'000};

  /// Real-time safe.
  void add(std::int64_t ns) noexcept {
    std::size_t bucket = 0;
    while (bucket < kBoundsNs.size() && ns > kBoundsNs[bucket]) ++bucket;
    ++counts[bucket];
    sum_s += static_cast<double>(ns) * 1e-9;
  }

  std::array<std::uint64_t, kBoundsNs.size() + 1> counts{};
  double sum_s = 0.0;
};

}  // namespace hedgehog::base

// SPDX-License-Identifier: MIT
// Time base: control ticks of one millisecond of device time. Durations and leases count ticks; the
// control path uses no other clock.
#pragma once

#include <cstdint>

namespace hedgehog::model {

/// A number of ticks since the daemon started, or a difference of two.
using Tick = std::int64_t;

inline constexpr Tick kTicksPerSecond = 1000;
inline constexpr std::int64_t kNanosecondsPerTick = 1'000'000;
inline constexpr double kTickSeconds = 1e-3;

}  // namespace hedgehog::model

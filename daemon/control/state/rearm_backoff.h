// SPDX-License-Identifier: MIT
// Exponential back-off of re-arming through the same trip, so that nobody heats a winding by arming
// through its trip.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/control/state/state.h"
#include "model/tick.h"

namespace hedgehog::control {

/// By reason: how often the ball was armed again after that trip.
using RearmCounts = std::array<std::uint8_t, kReasonCount>;

/// Control thread; real-time safe, trivially copyable.
class RearmBackoff {
 public:
  /// So many are free; the next one waits from the trip on, each further one twice as long.
  static constexpr int kFreeRearms = 3;
  static constexpr model::Tick kFirstWait = 10 * model::kTicksPerSecond;
  static constexpr model::Tick kMaxWait = 600 * model::kTicksPerSecond;
  /// So long armed without a trip takes one off each count.
  static constexpr model::Tick kForgiveAfter = 300 * model::kTicksPerSecond;

  RearmBackoff() noexcept = default;
  /// With the counts of the last run; a latch of that time waits from tick 0 on.
  explicit RearmBackoff(const RearmCounts& counts) noexcept : counts_(counts) {}

  void trip(model::Tick now) noexcept;
  /// The ball has been armed, and `latch` was cleared by that; kNone: none.
  void arm(Reason latch, model::Tick now) noexcept;
  /// Once a tick; `armed`: no trip since `arm`.
  void step(bool armed, model::Tick now) noexcept;

  /// Ticks until a ball that is latched by `latch` may be armed; 0: now.
  model::Tick wait(Reason latch, model::Tick now) const noexcept;
  const RearmCounts& counts() const noexcept { return counts_; }

 private:
  RearmCounts counts_{};
  model::Tick tripped_at_ = 0;
  model::Tick quiet_since_ = 0;
};

}  // namespace hedgehog::control

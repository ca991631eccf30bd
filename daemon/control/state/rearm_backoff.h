// SPDX-License-Identifier: MIT
// Exponential back-off of re-arming after the same trip, which could otherwise overheat a winding.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/control/state/state.h"
#include "model/tick.h"

namespace hedgehog::control {

/// Number of re-armings by trip reason.
using RearmCounts = std::array<std::uint8_t, kReasonCount>;

/// Control thread; real-time safe, trivially copyable.
class RearmBackoff {
 public:
  /// Re-armings without a wait; the next one waits from the trip on, each further twice as long.
  static constexpr int kFreeRearms = 3;
  static constexpr model::Tick kFirstWait = 10 * model::kTicksPerSecond;
  static constexpr model::Tick kMaxWait = 600 * model::kTicksPerSecond;
  /// Armed time without a trip that decrements each count.
  static constexpr model::Tick kResetAfter = 300 * model::kTicksPerSecond;

  RearmBackoff() noexcept = default;
  /// With the counts of the last run; its latch waits from tick 0 on.
  explicit RearmBackoff(const RearmCounts& counts) noexcept : counts_(counts) {}

  void trip(model::Tick now) noexcept;
  /// The ball has been armed, which cleared `latch`; kNone: there was none.
  void arm(Reason latch, model::Tick now) noexcept;
  /// Called once a tick; `armed`: no trip since `arm`.
  void step(bool armed, model::Tick now) noexcept;

  /// Ticks until a ball latched by `latch` may be armed; 0: now.
  model::Tick wait(Reason latch, model::Tick now) const noexcept;
  const RearmCounts& counts() const noexcept { return counts_; }

 private:
  RearmCounts counts_{};
  model::Tick tripped_at_ = 0;
  model::Tick quiet_since_ = 0;
};

}  // namespace hedgehog::control

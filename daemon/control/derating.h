// SPDX-License-Identifier: MIT
// Detects thermal derating of the active effects; the hold time bridges the periods of a vibration.
#pragma once

#include "model/tick.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class Derating {
 public:
  /// Ticks without a reduction until the derating ends.
  static constexpr model::Tick kHoldTicks = 500;
  /// Smaller reductions are not reported.
  static constexpr double kNoticeable = 0.995;

  /// The tick's norms: requested (already within the configured limit) and allowed by the limiter.
  void step(double requested_a, double allowed_a, model::Tick now) noexcept {
    if (requested_a > 0.0 && allowed_a < kNoticeable * requested_a) {
      reduced_ = now;
      active_ = true;
    } else if (now - reduced_ > kHoldTicks) {
      active_ = false;
    }
  }
  bool active() const noexcept { return active_; }

 private:
  model::Tick reduced_ = 0;
  bool active_ = false;
};

}  // namespace hedgehog::control

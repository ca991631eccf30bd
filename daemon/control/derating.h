// SPDX-License-Identifier: MIT
// Detects thermal derating of the active effects. With a hold time, so that a vibration does not
// toggle it every period.
#pragma once

#include "model/tick.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class Derating {
 public:
  /// It ends when nothing was reduced for this long.
  static constexpr model::Tick kPatience = 500;
  /// Less than this is not worth saying.
  static constexpr double kNoticeable = 0.995;

  /// The tick's norms: what was asked (already within the configured limit) and what heat allows.
  void step(double asked_a, double allowed_a, model::Tick now) noexcept {
    if (asked_a > 0.0 && allowed_a < kNoticeable * asked_a) {
      reduced_ = now;
      active_ = true;
    } else if (now - reduced_ > kPatience) {
      active_ = false;
    }
  }
  bool active() const noexcept { return active_; }

 private:
  model::Tick reduced_ = 0;
  bool active_ = false;
};

}  // namespace hedgehog::control

// SPDX-License-Identifier: MIT
// The best lap of whoever plays: laps that the built-in driver drove, even in part, are none of
// theirs.
#pragma once

#include <optional>

namespace hedgehog::racer {

class BestLap {
 public:
  /// Each step: who has the wheel.
  void drive(bool by_driver) noexcept { by_driver_ = by_driver_ || by_driver; }
  /// True while this lap is none of the player's own.
  bool by_driver() const noexcept { return by_driver_; }
  /// The lap ends after `time_s`; true: it is the best of the player's own.
  bool finish(double time_s) noexcept {
    const bool own = !by_driver_;
    by_driver_ = false;
    if (!own || (time_s_ && *time_s_ <= time_s)) return false;
    time_s_ = time_s;
    return true;
  }
  /// nullopt: no lap yet.
  std::optional<double> time_s() const noexcept { return time_s_; }

 private:
  std::optional<double> time_s_{};
  bool by_driver_ = false;
};

}  // namespace hedgehog::racer

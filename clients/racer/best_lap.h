// SPDX-License-Identifier: MIT
// The player's best lap: laps driven by the built-in driver, even in part, are ignored.
#pragma once

#include <optional>

namespace hedgehog::racer {

class BestLap {
 public:
  /// Each step: whether the built-in driver drives.
  void drive(bool by_driver) noexcept { by_driver_ = by_driver_ || by_driver; }
  /// True if the built-in driver drove in this lap.
  bool by_driver() const noexcept { return by_driver_; }
  /// The lap ends after `time_s`; true: it is the player's best.
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

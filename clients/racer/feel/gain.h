// SPDX-License-Identifier: MIT
// The game's own gain, from the thermal headroom of the ball: slightly reduced while the burst time
// is short, then further for as long as the daemon derates; slow recovery.
#pragma once

#include <algorithm>
#include <optional>

namespace hedgehog::racer {

class Gain {
 public:
  /// Below 40 % the steps of a blow could not be distinguished, see steps.h.
  static constexpr double kMin = 0.4;
  /// Sufficient burst time at full strength, s: 16 impacts; without any the game plays at 70 %.
  static constexpr double kEnoughS = 3.0;
  static constexpr double kZeroReserveGain = 0.7;
  static constexpr double kDownPerS = 0.6;
  static constexpr double kUpPerS = 0.02;

  double now() const noexcept { return now_; }

  /// `derating`: the daemon derates the effects. `burst_s`: remaining burst time at full strength;
  /// nullopt: unlimited. `passed_s`: since the last call, device time.
  void take(bool derating, const std::optional<double>& burst_s, double passed_s) noexcept {
    const double reserve = burst_s ? std::clamp(*burst_s / kEnoughS, 0.0, 1.0) : 1.0;
    const double goal = derating ? kMin : kZeroReserveGain + (1.0 - kZeroReserveGain) * reserve;
    now_ = goal < now_ ? std::max(goal, now_ - kDownPerS * passed_s)
                       : std::min(goal, now_ + kUpPerS * passed_s);
  }

 private:
  double now_ = 1.0;
};

}  // namespace hedgehog::racer

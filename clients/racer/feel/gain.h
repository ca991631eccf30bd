// SPDX-License-Identifier: MIT
// How strong the game plays, by what the ball can still take: a little softer while full strength
// could not last, then less and less for as long as the daemon reduces what is played; back slowly.
#pragma once

#include <algorithm>
#include <optional>

namespace hedgehog::racer {

class Gain {
 public:
  /// Below 40 % the steps of a blow would be too close to be told apart, see steps.h.
  static constexpr double kMin = 0.4;
  /// Full strength should be possible for so long, 16 blows; with nothing in hand the game plays
  /// at 70 %.
  static constexpr double kEnoughS = 3.0;
  static constexpr double kNothingInHand = 0.7;
  static constexpr double kDownPerS = 0.6;
  static constexpr double kUpPerS = 0.02;

  double now() const noexcept { return now_; }

  /// `derating`: the daemon reduces what is played. `burst_s`: how long full strength could last;
  /// nothing: for ever. `passed_s`: since the last call, device time.
  void take(bool derating, const std::optional<double>& burst_s, double passed_s) noexcept {
    const double in_hand = burst_s ? std::clamp(*burst_s / kEnoughS, 0.0, 1.0) : 1.0;
    const double goal = derating ? kMin : kNothingInHand + (1.0 - kNothingInHand) * in_hand;
    now_ = goal < now_ ? std::max(goal, now_ - kDownPerS * passed_s)
                       : std::min(goal, now_ + kUpPerS * passed_s);
  }

 private:
  double now_ = 1.0;
};

}  // namespace hedgehog::racer

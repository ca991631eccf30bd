// SPDX-License-Identifier: MIT
// The most that the shell can be where the hand holds it, from the estimated core: what limits the
// current of a ball without a thermometer under its skin, and leads one that has it. Constants: a
// shell that insulates badly, model/skin.md.
#pragma once

#include <limits>

#include "model/estimate/thermal_filter.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// The skin settles so far on the way from the room to the core, and follows with this lag.
inline constexpr double kSkinShare = 0.7;
inline constexpr double kSkinLagS = 60.0;

/// The core at its warmest if no current flowed from now on, C: the heat that is still in the
/// windings comes out through it. Never below the core as it is. `to_room_k_w`: from core to room
/// (> 0). Exact for three equal windings.
double coming_core_c(const ThermalModel& thermal, const ThermalState& nodes, double ambient_c,
                     double to_room_k_w) noexcept;

/// The skin that belongs to a core that stays as it is, C.
constexpr double settled_skin_c(double core_c, double ambient_c) noexcept {
  return ambient_c + kSkinShare * (core_c - ambient_c);
}

/// What the estimate follows. Trivially copyable.
struct SkinInputs {
  ThermalState nodes;
  double ambient_c = 25.0;
  /// From core to room now, K/W.
  double to_room_k_w = 1.8;
  /// Standard deviation of `settled_skin_c` by what is uncertain of core and room, K.
  double deviation_k = 0.0;

  static SkinInputs of(const ThermalModel& thermal, const ThermalFilter& filter,
                       bool fan_running) noexcept;
  /// Of nodes that are known.
  static SkinInputs of(const ThermalModel& thermal, const ThermalState& nodes, double ambient_c,
                       bool fan_running) noexcept;
};

/// Real-time safe, trivially copyable; control thread, or whoever previews.
class SkinEstimate {
 public:
  /// The bound stands above the estimate by so many standard deviations, but at least and at most
  /// this, K: the least is what thermistors may be off by together with the room, the most is for a
  /// restart without saved temperatures.
  static constexpr double kDeviations = 0.8;
  static constexpr double kMinMarginK = 1.3;
  static constexpr double kMaxMarginK = 3.0;

  SkinEstimate() noexcept = default;
  explicit SkinEstimate(const ThermalModel& thermal) noexcept : thermal_(thermal) {}

  /// `dt_s` (any step) later. The first call starts it, with a skin that has settled.
  void step(const SkinInputs& in, double dt_s) noexcept;

  /// The most that the skin is, or will be by the heat that is already in the ball, C. Infinite
  /// before the first step; not a number when the inputs were not.
  double celsius() const noexcept { return bound_c_; }
  /// So much of it is still to come, K (>= 0): the core now or soon against the core that the skin
  /// has followed so far.
  double coming_k() const noexcept { return coming_k_; }
  /// The same without margin, C; and the margin, K.
  double heated_c() const noexcept { return following_c_ + coming_k_; }
  double margin_k() const noexcept { return margin_k_; }
  /// The skin as it is by the nodes alone, C.
  double following_c() const noexcept { return following_c_; }

 private:
  ThermalModel thermal_;
  bool started_ = false;
  double following_c_ = 25.0;
  double bound_c_ = std::numeric_limits<double>::infinity();
  double coming_k_ = 0.0;
  double margin_k_ = kMinMarginK;
};

}  // namespace hedgehog::model

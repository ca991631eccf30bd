// SPDX-License-Identifier: MIT
// Upper bound of the shell temperature at the hand, from the estimated core. Limits the current of
// a ball without a skin thermometer; feed-forward for one that has it. Constants: a poorly
// insulating shell, model/skin.md.
#pragma once

#include <limits>

#include "model/estimate/thermal_filter.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// The skin settles at this share of the way from ambient to core, with this time constant.
inline constexpr double kSkinShare = 0.7;
inline constexpr double kSkinLagS = 60.0;

/// Maximum core temperature if no current flowed from now on, C: the heat stored in the windings
/// flows out through the core. Never below the present core temperature. `to_ambient_k_w`: thermal
/// resistance from core to ambient (> 0). Exact for three equal windings.
double forecast_core_c(const ThermalModel& thermal, const ThermalState& nodes, double ambient_c,
                       double to_ambient_k_w) noexcept;

/// Steady-state skin temperature at a constant core temperature, C.
constexpr double settled_skin_c(double core_c, double ambient_c) noexcept {
  return ambient_c + kSkinShare * (core_c - ambient_c);
}

/// Inputs of the estimate. Trivially copyable.
struct SkinInputs {
  ThermalState nodes;
  double ambient_c = 25.0;
  /// Thermal resistance from core to ambient now, K/W.
  double to_ambient_k_w = 1.8;
  /// Standard deviation of `settled_skin_c` due to the uncertainty of core and ambient, K.
  double deviation_k = 0.0;

  static SkinInputs of(const ThermalModel& thermal, const ThermalFilter& filter,
                       bool fan_running) noexcept;
  /// With exactly known nodes.
  static SkinInputs of(const ThermalModel& thermal, const ThermalState& nodes, double ambient_c,
                       bool fan_running) noexcept;
};

/// Real-time safe, trivially copyable; control thread, or the thread of a preview.
class SkinEstimate {
 public:
  /// Margin of the bound above the estimate: kDeviations standard deviations, clamped to these
  /// limits, K. The minimum covers the common error of thermistors and ambient, the maximum a
  /// restart without saved temperatures.
  static constexpr double kDeviations = 0.8;
  static constexpr double kMinMarginK = 1.3;
  static constexpr double kMaxMarginK = 3.0;

  SkinEstimate() noexcept = default;
  explicit SkinEstimate(const ThermalModel& thermal) noexcept : thermal_(thermal) {}

  /// Advances by `dt_s` (any step). The first call starts from a settled skin.
  void step(const SkinInputs& in, double dt_s) noexcept;
  /// The same in two parts, for inputs that change more seldom than the step: `set` takes them,
  /// `step` advances. Until the first `set` the bound stays infinite.
  void set(const SkinInputs& in) noexcept;
  void step(double dt_s) noexcept;

  /// Upper bound of the skin temperature, now or later due to heat already in the ball, C. Infinite
  /// before the first step; NaN if an input was NaN.
  double celsius() const noexcept { return bound_c_; }
  /// Part of it that is still to come, K (>= 0).
  double forecast_rise_k() const noexcept { return forecast_rise_k_; }
  /// `celsius` without margin, C; and the margin, K.
  double heated_c() const noexcept { return following_c_ + forecast_rise_k_; }
  double margin_k() const noexcept { return margin_k_; }
  /// Present skin temperature by the nodes alone, C.
  double following_c() const noexcept { return following_c_; }

 private:
  ThermalModel thermal_;
  /// Of the inputs: steady-state skin temperature now, and at the core's maximum, C.
  double goal_c_ = 25.0;
  double forecast_c_ = std::numeric_limits<double>::infinity();
  /// Share of the way to the goal that a step of `step_s_` takes.
  double step_s_ = 0.0;
  double step_share_ = 0.0;
  bool started_ = false;
  double following_c_ = 25.0;
  double bound_c_ = std::numeric_limits<double>::infinity();
  double forecast_rise_k_ = 0.0;
  double margin_k_ = kMinMarginK;
};

}  // namespace hedgehog::model

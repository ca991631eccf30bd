// SPDX-License-Identifier: MIT
// Upper bound of the shell temperature at the hand, from the estimated core: limits the current of
// a ball without a skin thermometer; feed-forward for one with it. Constants: model/skin.md.
#pragma once

#include <limits>

#include "model/estimate/thermal_filter.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// The skin settles at this share of the way from ambient to core, with this time constant.
inline constexpr double kSkinShare = 0.7;
inline constexpr double kSkinLagS = 60.0;

/// Maximum core temperature if no current flowed from now on, by the heat in the windings; at least
/// the present one. `to_ambient_k_w`: from the core, > 0. Exact for three equal windings.
double forecast_core_c(const ThermalModel& thermal, const ThermalState& nodes, double ambient_c,
                       double to_ambient_k_w) noexcept;

/// Steady-state skin temperature at a constant core temperature.
constexpr double settled_skin_c(double core_c, double ambient_c) noexcept {
  return ambient_c + kSkinShare * (core_c - ambient_c);
}

/// Trivially copyable.
struct SkinInputs {
  ThermalState nodes;
  double ambient_c = 25.0;
  double to_ambient_k_w = 1.8;  // from the core, at present
  double deviation_k = 0.0;  // standard deviation of `settled_skin_c` by that of core and ambient

  static SkinInputs of(const ThermalModel& thermal, const ThermalFilter& filter,
                       bool fan_running) noexcept;
  /// With exactly known nodes.
  static SkinInputs of(const ThermalModel& thermal, const ThermalState& nodes, double ambient_c,
                       bool fan_running) noexcept;
};

/// Real-time safe, trivially copyable; control thread, or the thread of a preview.
class SkinEstimate {
 public:
  /// Margin of the bound: kDeviations standard deviations, clamped. The minimum covers the common
  /// error of thermistors and ambient, the maximum a restart without saved temperatures.
  static constexpr double kDeviations = 0.8;
  static constexpr double kMinMarginK = 1.3;
  static constexpr double kMaxMarginK = 3.0;

  SkinEstimate() noexcept = default;
  explicit SkinEstimate(const ThermalModel& thermal) noexcept : thermal_(thermal) {}

  /// Advances by `dt_s` (any step). The first call starts from a settled skin.
  void step(const SkinInputs& in, double dt_s) noexcept;
  /// The same in two parts, for inputs that change seldom. Infinite bound until the first `set`.
  void set(const SkinInputs& in) noexcept;
  void step(double dt_s) noexcept;

  /// Upper bound of the skin temperature, now or later by heat already in the ball. Infinite before
  /// the first step; NaN if an input was NaN.
  double celsius() const noexcept { return bound_c_; }
  double forecast_rise_k() const noexcept { return forecast_rise_k_; }  // still to come, >= 0
  double heated_c() const noexcept { return following_c_ + forecast_rise_k_; }  // without margin
  double margin_k() const noexcept { return margin_k_; }
  double following_c() const noexcept { return following_c_; }  // at present, by the nodes alone

 private:
  ThermalModel thermal_;
  /// Of the inputs: steady-state skin temperature now, and at the core's maximum.
  double goal_c_ = 25.0;
  double forecast_c_ = std::numeric_limits<double>::infinity();
  double step_s_ = 0.0;
  double step_share_ = 0.0;  // of the way to the goal, in a step of `step_s_`
  bool started_ = false;
  double following_c_ = 25.0;
  double bound_c_ = std::numeric_limits<double>::infinity();
  double forecast_rise_k_ = 0.0;
  double margin_k_ = kMinMarginK;
};

}  // namespace hedgehog::model

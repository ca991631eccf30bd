// SPDX-License-Identifier: MIT
// Simulation of the ball under a constant load, with its fan and skin, for the forecast.
#pragma once

#include <array>

#include "model/limit/forecast_start.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::model {

/// No allocation; the references must outlive it.
class HeatCourse {
 public:
  /// `rms_a`: rms current of each winding from now on.
  HeatCourse(const CoilModel& coils, const ThermalModel& thermal, const ForecastStart& start,
             const Vec3& rms_a) noexcept;

  /// One step; false once all nodes have settled or the horizon (4 h) is reached.
  bool step() noexcept;

  double hottest_c() const noexcept { return hottest_winding(nodes_); }
  /// Limiting skin temperature, C; -infinity: no skin limit.
  double skin_c() const noexcept { return skin_.heated_c() + skin_above_k_; }
  double time_s() const noexcept { return time_s_; }

 private:
  void follow_skin(double dt_s) noexcept;
  ThermalState rates(const ThermalState& nodes) noexcept;

  const CoilModel& coils_;
  const ThermalModel& thermal_;
  ThermalState nodes_;
  SkinEstimate skin_;
  double skin_above_k_ = 0.0;
  HeatLoad load_;
  std::array<double, kCoils> squares_a2_{};
  double norm_a_ = 0.0;
  double mean_a_ = 0.0;
  double time_s_ = 0.0;
  double longest_s_ = 1.0;
  int steps_ = 0;
  bool fan_works_ = true;
};

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
#include "model/estimate/skin_estimate.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {

// With x = core - ambient, s = the sum of the windings' temperatures above the core, and no loss:
//   x' = -a x + b s,   s' = 3 a x - (c + 3 b) s
// a = 1 / (R_room C_core), b = 1 / (R_winding C_core), c = 1 / (R_winding C_winding). For unequal
// windings the mean is used, and the heat stored in each. Both eigenvalues -p, -q are real and
// negative, so x rises to one maximum at most, in closed form.
double forecast_core_c(const ThermalModel& thermal, const ThermalState& nodes, double ambient_c,
                       double to_ambient_k_w) noexcept {
  const double a = 1.0 / (to_ambient_k_w * thermal.core_j_k);
  double to_core_w_k = 0.0;
  double winding_j_k = 0.0;
  double above_j = 0.0;
  for (std::size_t i = 0; i < kCoils; ++i) {
    to_core_w_k += 1.0 / thermal.winding_to_core_k_w[i] / kCoils;
    winding_j_k += thermal.winding_j_k[i] / kCoils;
    above_j += thermal.winding_j_k[i] * (nodes.winding_c[i] - nodes.core_c);
  }
  const double b = to_core_w_k / thermal.core_j_k;
  const double c = to_core_w_k / winding_j_k;
  const double x = nodes.core_c - ambient_c;
  const double s = above_j / winding_j_k;
  const double rising = b * s - a * x;
  // A core below ambient rises to ambient at most, which is no bound by heat.
  if (rising <= 0.0 || x < 0.0) return nodes.core_c;
  const double sum = a + c + static_cast<double>(kCoils) * b;
  const double apart = std::sqrt(sum * sum - 4.0 * a * c);
  const double p = 0.5 * (sum + apart);
  const double q = a * c / p;
  const double fast = rising + q * x;
  const double slow = rising + p * x;
  const double at_s = std::log(p * fast / (q * slow)) / apart;
  const double peak = (slow * std::exp(-q * at_s) - fast * std::exp(-p * at_s)) / apart;
  return ambient_c + peak;
}

SkinInputs SkinInputs::of(const ThermalModel& thermal, const ThermalState& nodes, double ambient_c,
                          bool fan_running) noexcept {
  SkinInputs in;
  in.nodes = nodes;
  in.ambient_c = ambient_c;
  in.to_ambient_k_w =
      fan_running ? thermal.core_to_ambient_fan_k_w : thermal.core_to_ambient_still_k_w;
  return in;
}

SkinInputs SkinInputs::of(const ThermalModel& thermal, const ThermalFilter& filter,
                          bool fan_running) noexcept {
  SkinInputs in = of(thermal, filter.nodes(), filter.ambient_c(), fan_running);
  in.to_ambient_k_w /= filter.cooling();
  in.deviation_k = filter.between_deviation_k(kSkinShare);
  return in;
}

void SkinEstimate::step(const SkinInputs& in, double dt_s) noexcept {
  set(in);
  step(dt_s);
}

void SkinEstimate::set(const SkinInputs& in) noexcept {
  goal_c_ = settled_skin_c(in.nodes.core_c, in.ambient_c);
  forecast_c_ = settled_skin_c(forecast_core_c(thermal_, in.nodes, in.ambient_c, in.to_ambient_k_w),
                               in.ambient_c);
  margin_k_ = std::clamp(kDeviations * in.deviation_k, kMinMarginK, kMaxMarginK);
  if (!started_) following_c_ = goal_c_;
  started_ = true;
}

void SkinEstimate::step(double dt_s) noexcept {
  if (dt_s != step_s_) {
    step_s_ = dt_s;
    step_share_ = -std::expm1(-dt_s / kSkinLagS);
  }
  following_c_ += (goal_c_ - following_c_) * step_share_;
  forecast_rise_k_ = std::max(0.0, forecast_c_ - following_c_);
  bound_c_ = heated_c() + margin_k_;
}

}  // namespace hedgehog::model

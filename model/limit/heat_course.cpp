// SPDX-License-Identifier: MIT
#include "model/limit/heat_course.h"

#include <algorithm>
#include <cmath>

#include "model/thermal/fan.h"

namespace hedgehog::model {
namespace {

constexpr double kHorizonS = 4.0 * 3600.0;
// Below this rate no further crossing is expected: the remaining change is this times the time
// constant of the ball, 0.05 K with fan and 0.13 K without.
constexpr double kSettledK_s = 1e-4;

// Maximum change of the nodes in a step (crossings are interpolated linearly). The integration is
// stable and exact to 0.01 K; a step is at least a tick.
constexpr double kStepK = 0.5;
constexpr double kShortestS = 1e-3;
constexpr double kLongestWhileFanIsOpenS = 2.0;
// A very light ball in a device file may reach this before the horizon; an ordinary one needs a
// third of it.
constexpr int kMaxForecastSteps = 4000;

double steepest(const ThermalState& rate) noexcept {
  double fastest = std::abs(rate.core_c);
  for (const double r : rate.winding_c) fastest = std::max(fastest, std::abs(r));
  return fastest;
}

}  // namespace

HeatCourse::HeatCourse(const CoilModel& coils, const ThermalModel& thermal,
                       const ForecastStart& start, const Vec3& rms_a) noexcept
    : coils_(coils),
      thermal_(thermal),
      nodes_(start.nodes),
      skin_(start.skin),
      skin_above_k_(start.skin_above_k),
      mean_a_(start.mean_current_a) {
  load_.ambient_c = start.ambient_c;
  load_.fan_running = start.fan_running && start.fan_works;
  fan_works_ = start.fan_works;
  norm_a_ = norm(rms_a);
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    squares_a2_[i] = rms_a[coil] * rms_a[coil];
  }
  // Gershgorin: no eigenvalue of the four nodes is beyond twice the diagonal of its row.
  const double to_ambient_k_w =
      std::min(thermal.core_to_ambient_fan_k_w, thermal.core_to_ambient_still_k_w);
  double core = 1.0 / (to_ambient_k_w * thermal.core_j_k);
  double winding = 0.0;
  for (std::size_t i = 0; i < kCoils; ++i) {
    const double to_core_w_k = 1.0 / thermal.winding_to_core_k_w[i];
    core += 2.0 * to_core_w_k / thermal.core_j_k;
    winding = std::max(winding, 2.0 * to_core_w_k / thermal.winding_j_k[i]);
  }
  longest_s_ = 1.0 / std::max(core, winding);
  follow_skin(0.0);
}

bool HeatCourse::step() noexcept {
  load_.fan_running = fan_works_ && Fan::runs(load_.fan_running, hottest_c(), mean_a_);
  const ThermalState k1 = rates(nodes_);
  const bool mean_settled = std::abs(norm_a_ - mean_a_) < 0.01;
  const double fastest = steepest(k1);
  if (fastest <= kSettledK_s && mean_settled) return false;
  double dt_s = mean_settled ? longest_s_ : std::min(longest_s_, kLongestWhileFanIsOpenS);
  dt_s = std::max(kShortestS, std::min(dt_s, kStepK / fastest));
  const ThermalState k2 = rates(advanced(nodes_, k1, 0.5 * dt_s));
  const ThermalState k3 = rates(advanced(nodes_, k2, 0.5 * dt_s));
  const ThermalState k4 = rates(advanced(nodes_, k3, dt_s));
  for (std::size_t i = 0; i < kCoils; ++i)
    nodes_.winding_c[i] +=
        dt_s / 6.0 *
        (k1.winding_c[i] + 2.0 * (k2.winding_c[i] + k3.winding_c[i]) + k4.winding_c[i]);
  nodes_.core_c += dt_s / 6.0 * (k1.core_c + 2.0 * (k2.core_c + k3.core_c) + k4.core_c);
  time_s_ += dt_s;
  follow_skin(dt_s);
  mean_a_ += (norm_a_ - mean_a_) * (1.0 - std::exp(-dt_s / Fan::kMeanS));
  return time_s_ < kHorizonS && ++steps_ < kMaxForecastSteps;
}

ThermalState HeatCourse::rates(const ThermalState& nodes) noexcept {
  for (std::size_t i = 0; i < kCoils; ++i)
    load_.loss_w[i] =
        squares_a2_[i] * resistance_at(Ohms(coils_.r25_ohm[i]), Celsius(nodes.winding_c[i])).value;
  return heating_rates(thermal_, nodes, load_);
}

void HeatCourse::follow_skin(double dt_s) noexcept {
  if (!std::isfinite(skin_above_k_)) return;
  skin_.step(SkinInputs::of(thermal_, nodes_, load_.ambient_c, load_.fan_running), dt_s);
}

}  // namespace hedgehog::model

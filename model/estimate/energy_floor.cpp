// SPDX-License-Identifier: MIT
#include "model/estimate/energy_floor.h"

#include <algorithm>

#include "model/thermal/thermal_flow.h"

namespace hedgehog::model {
namespace {

// Voltage and current may each read 2 % high.
constexpr double kMinLossShare = 0.96;
constexpr double kAmbientToleranceK = 1.0;

// Rates at which the thermistors correct the model.
constexpr double kCoreS = 60.0;
constexpr double kMaxCoreRateK_s = 0.05;
constexpr double kWindingOwnS = 6.0;    // several thermistors
constexpr double kWindingOnlyS = 10.0;  // a single thermistor
constexpr double kAmbientPerS = 5e-4;
constexpr double kMaxAmbientRateK_s = 1e-3;

}  // namespace

EnergyFloor::EnergyFloor(const ThermalModel& thermal, double tolerance, const ThermalState& start,
                         double ambient_c) noexcept
    : thermal_(thermal), nodes_(start), body_c_(start.winding_c), ambient_c_(ambient_c) {
  ambient_c_ -= kAmbientToleranceK;
  for (double& value : thermal_.winding_j_k) value *= 1.0 + tolerance;
  for (double& value : thermal_.winding_to_core_k_w) value /= 1.0 + tolerance;
  thermal_.core_to_ambient_fan_k_w /= 1.0 + tolerance;
  thermal_.core_to_ambient_still_k_w /= 1.0 + tolerance;
}

void EnergyFloor::step(const std::array<double, kCoils>& loss_w, bool fan_running,
                       const ThermistorReadings& thermistors, double dt_s) noexcept {
  HeatLoad load;
  load.ambient_c = ambient_c_;
  load.fan_running = fan_running;
  for (std::size_t i = 0; i < kCoils; ++i) load.loss_w[i] = kMinLossShare * loss_w[i];
  nodes_ = advanced(nodes_, heating_rates(thermal_, nodes_, load), dt_s);
  const int count = thermistors.count();
  for (std::size_t i = 0; i < kCoils; ++i) {
    double& body = body_c_[i];
    body += (nodes_.winding_c[i] - body) * std::min(1.0, dt_s / thermal_.sensor_lag_s);
    if (!thermistors.valid[i]) continue;
    const double error_k = thermistors.celsius[i] - body;
    nodes_.winding_c[i] += error_k * dt_s / (count > 1 ? kWindingOwnS : kWindingOnlyS);
    nodes_.core_c += std::clamp(error_k / kCoreS, -kMaxCoreRateK_s, kMaxCoreRateK_s) * dt_s / count;
    ambient_c_ +=
        std::clamp(error_k * kAmbientPerS, -kMaxAmbientRateK_s, kMaxAmbientRateK_s) * dt_s;
  }
}

}  // namespace hedgehog::model

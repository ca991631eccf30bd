// SPDX-License-Identifier: MIT
// Lower bound of the windings' temperatures by energy balance: a ball whose heat capacities and
// conductances are all at the upper end of their tolerance, corrected slowly by its thermistors.
#pragma once

#include <array>

#include "model/coils.h"
#include "model/estimate/thermistor_readings.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// Real-time safe, trivially copyable.
class EnergyFloor {
 public:
  EnergyFloor() noexcept : EnergyFloor(ThermalModel{}, 0.2, ThermalState{}, 25.0) {}
  /// `tolerance`: relative, of the thermal constants.
  EnergyFloor(const ThermalModel& thermal, double tolerance, const ThermalState& start,
              double ambient_c) noexcept;

  /// Advances by `dt_s` with the losses `loss_w` of the windings.
  void step(const std::array<double, kCoils>& loss_w, bool fan_running,
            const ThermistorReadings& thermistors, double dt_s) noexcept;

  double winding_c(int coil) const noexcept {
    return nodes_.winding_c[static_cast<std::size_t>(coil)];
  }

 private:
  ThermalModel thermal_;
  ThermalState nodes_;
  std::array<double, kCoils> body_c_{};
  double ambient_c_ = 25.0;
};

}  // namespace hedgehog::model

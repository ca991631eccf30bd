// SPDX-License-Identifier: MIT
// Lower bound of the windings' temperatures by energy balance: a ball whose heat capacities and
// conductances are all at the upper end of their tolerance, corrected slowly by its thermistors. Of
// resistances it uses only those by which the loss was measured.
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
  /// `tolerance`: of the thermal constants, a share.
  EnergyFloor(const ThermalModel& thermal, double tolerance, const ThermalState& start,
              double ambient_c) noexcept;

  /// `dt_s` later, in which the windings lost `loss_w` as heat.
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

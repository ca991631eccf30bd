// SPDX-License-Identifier: MIT
#include "daemon/control/heat_check.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::control {

HeatCheck::HeatCheck(const model::CoilModel& coils) noexcept : r25_ohm_(coils.r25_ohm) {
  meters_.fill(model::WindingMeter(coils.inductance_h));
}

Reason HeatCheck::step(const HeatReading& reading, double trip_c, double dt_s) noexcept {
  // A tick without telemetry says nothing about the thermistor.
  if (reading.fresh) {
    const bool high = reading.sensor && reading.sensor_c >= trip_c;
    sensor_due_ = sensor_hot_.step(high, reading.since_s, kHoldS);
  }
  const double coldest_c =
      (reading.sensor ? std::min(reading.sensor_c, kColdRoomC) : kColdRoomC) - kTooColdK;
  bool hot = sensor_due_;
  bool too_cold = false;
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    meters_[i].step(reading.voltage_v[coil], reading.before_a[coil], reading.after_a[coil],
                    reading.electrical, dt_s);
    // What is only remembered of a winding is no further evidence, for or against.
    const double mean_a = 0.5 * std::abs(reading.before_a[coil] + reading.after_a[coil]);
    const bool told = reading.electrical && mean_a >= model::WindingMeter::kLeastCurrentA;
    if (measuring(coil) && !told) continue;
    const double since_s = measuring(coil) ? dt_s : kForgets * dt_s;
    hot |= hot_[i].step(measuring(coil) && winding_c(coil) >= trip_c, since_s, kHoldS);
    const bool cold = measuring(coil) && winding_c(coil) < coldest_c;
    too_cold |= too_cold_[i].step(cold, since_s, kTooColdHoldS);
  }
  if (hot) return Reason::kOverheated;
  return too_cold ? Reason::kCurrentMismatch : Reason::kNone;
}

bool HeatCheck::measuring(int coil) const noexcept {
  return meters_[static_cast<std::size_t>(coil)].valid();
}

double HeatCheck::winding_c(int coil) const noexcept {
  const auto i = static_cast<std::size_t>(coil);
  return temperature_at(model::Ohms(r25_ohm_[i]), model::Ohms(meters_[i].resistance_ohm())).value;
}

}  // namespace hedgehog::control

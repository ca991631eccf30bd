// SPDX-License-Identifier: MIT
// Inputs of a thermal observer: measurements of a millisecond, and a start.
#pragma once

#include "model/estimate/thermal_observer.h"

namespace hedgehog::model {

inline ThermalMeasurement quiet(double sensor_c) {
  ThermalMeasurement m;
  m.electrical_valid = true;
  m.thermistors.celsius[0] = sensor_c;
  m.thermistors.valid[0] = true;
  return m;
}

/// A ball known to have the uniform temperature `celsius`.
inline ThermalStart known(double celsius) {
  ThermalStart start;
  start.nodes = {{celsius, celsius, celsius}, celsius};
  start.known = true;
  start.measured.fill(true);
  return start;
}

/// The measurement when winding `coil` of 0.45 ohm at 25 C carries `current` at `celsius`.
inline ThermalMeasurement measurement(int coil, double current, double celsius, double sensor_c) {
  ThermalMeasurement m = quiet(sensor_c);
  m.current_before_a[coil] = current;
  m.current_a[coil] = current;
  m.voltage_v[coil] = current * resistance_at(Ohms(0.45), Celsius(celsius)).value;
  m.fan_running = true;
  return m;
}

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// The thermistor check with readings as a board sends them.
#pragma once

#include <utility>

#include "daemon/control/checks/thermistor_check.h"
#include "model/tick.h"

namespace hedgehog::control {

/// A thermistor that is sampled every 10 ms.
class Sensor {
 public:
  Reason step(double sensor_c, bool converts = true) {
    if (converts && ++ticks_ % 10 == 0) ++reading.conversions;
    reading.fresh = true;
    reading.sensor_c = sensor_c;
    return check.step(reading, model::kTickSeconds);
  }
  /// Ticks until the check returns a reason, at most `max_ticks`.
  std::pair<Reason, int> until_trip(double sensor_c, int max_ticks, bool converts = true) {
    for (int i = 1; i <= max_ticks; ++i)
      if (const Reason reason = step(sensor_c, converts); reason != Reason::kNone)
        return {reason, i};
    return {Reason::kNone, max_ticks};
  }
  ThermistorCheck check;
  SensorReading reading;

 private:
  int ticks_ = 0;
};

}  // namespace hedgehog::control

// SPDX-License-Identifier: MIT
// Settings of the controller, fixed before its first tick. Trivially copyable.
#pragma once

#include <array>
#include <type_traits>

#include "daemon/control/state/rearm_backoff.h"
#include "daemon/control/state/state.h"
#include "daemon/device/thermometer/sample.h"
#include "model/coils.h"
#include "model/limit/limits.h"
#include "model/thermal/thermal_model.h"
#include "model/thermal/thermal_uncertainty.h"
#include "model/tick.h"

namespace hedgehog::control {

struct ControlSettings {
  model::CoilModel coils;
  model::ThermalModel thermal;
  /// Role of the second thermometer; kNone: not present.
  device::ThermometerRole thermometer = device::ThermometerRole::kNone;
  model::Limits limits;                   // configured
  model::Limits ceiling;                  // of the device file; `SetLimits` beyond it is ignored
  model::ThermalUncertainty uncertainty;  // tolerances of `thermal` and `coils` for this ball
  double gain = 1.0;                      // the owner's comfort setting, 0..1

  /// Arm once the first board is detected without a fault, unless a latch was saved. Main derives
  /// it from `arm_at_start` and the end of the last run; always true for the simulator.
  bool arm_at_start = false;
  /// Reason for being disarmed at the first detection otherwise: kNeverArmed or kUncleanStop.
  Reason start_reason = Reason::kNeverArmed;
  /// A board first detected later than this after the start counts as hot-plugged and is not armed.
  /// Unlimited for the simulated board, however slow the machine.
  model::Tick start_timeout = 10'000;
  Reason latch = Reason::kNone;  // saved by the last run; kNone: none
  RearmCounts rearms{};          // of the last runs

  /// `start` was read from a valid file: each node then starts at max(`start`, thermistor). False:
  /// every node starts at the thermistor's reading.
  bool start_known = false;
  model::ThermalState start;
  double start_deviation_k = 0.3;  // standard deviation of each node of `start`
  /// Windings whose `start` is based on their own measurement. The others are limited to
  /// `continuous_a` until their own V/I has been measured.
  std::array<bool, model::kCoils> start_measured{};
  double start_ambient_c = 25.0;  // saved; used when `start_known`; NaN or infinite: unknown
};

static_assert(std::is_trivially_copyable_v<ControlSettings>);

}  // namespace hedgehog::control

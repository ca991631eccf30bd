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
  /// What the second thermometer is for; kNone: there is none.
  device::ThermometerRole thermometer = device::ThermometerRole::kNone;
  /// As configured, and what the device file allows at most (`SetLimits` beyond it is ignored).
  model::Limits limits;
  model::Limits ceiling;
  /// By how much this ball may differ from `thermal` and `coils`.
  model::ThermalUncertainty uncertainty;
  /// The owner's comfort setting, 0..1.
  double gain = 1.0;

  /// Arm as soon as a sane board is seen for the first time (`arm_at_start` and how the last run
  /// ended, already weighed by main; always true for the simulator). A saved latch wins.
  bool arm_at_start = false;
  /// Why the ball is disarmed at its first sight otherwise: kNeverArmed or kUncleanStop.
  Reason start_reason = Reason::kNeverArmed;
  /// A board that is first seen later than this after the start has been plugged in since, and is
  /// not armed at its first sight. The simulated one was there, however slow the machine.
  model::Tick start_patience = 10'000;
  /// The latch saved by the last run; kNone: none.
  Reason latch = Reason::kNone;
  /// How often the last runs armed again after which trip.
  RearmCounts rearms{};

  /// `start` was read from a good file: each node then starts at max(`start`, thermistor). False:
  /// every node starts at the thermistor's reading.
  bool start_known = false;
  model::ThermalState start;
  /// Standard deviation of each of its nodes, K.
  double start_deviation_k = 0.3;
  /// Windings whose `start` goes back to a measurement of theirs. The others are held to
  /// `continuous_a` until their own V/I has measured.
  std::array<bool, model::kCoils> start_measured{};
  /// Saved room temperature, used when `start_known`; NaN or infinite: unknown.
  double start_room_c = 25.0;
};

static_assert(std::is_trivially_copyable_v<ControlSettings>);

}  // namespace hedgehog::control

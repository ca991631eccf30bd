// SPDX-License-Identifier: MIT
// The second layer of safety: everything that must stop the ball whatever the limiter thinks
// (DESIGN section 6). Uses the raw thermistor and its own filtered V/I only.
#pragma once

#include "daemon/control/board_check.h"
#include "daemon/control/current_check.h"
#include "daemon/control/fan_check.h"
#include "daemon/control/heat_check.h"
#include "daemon/control/sensor_check.h"
#include "daemon/control/state.h"
#include "daemon/control/telemetry_pair.h"
#include "daemon/control/thermometer_check.h"
#include "daemon/device/board_io.h"
#include "model/coils.h"
#include "model/tick.h"

namespace hedgehog::control {

/// One tick of what the watchdog sees. Made and used on the control thread.
struct WatchdogInputs {
  bool board_present = false;
  bool fresh = false;
  const device::BoardTelemetry& board;
  const TelemetryPair& pair;
  /// The set-point of the last tick.
  const device::BoardCommand& commanded;
  double trip_c = 70.0;
  /// Ticks since the last step, 1 or more.
  model::Tick ticks = 1;
  /// Otherwise only what stops a ball in every state counts.
  bool armed = true;
  model::Tick now = 0;
  device::ThermometerSample thermometer;
};

/// Control thread; real-time safe, trivially copyable.
class Watchdog {
 public:
  Watchdog() noexcept = default;
  Watchdog(const model::CoilModel& coils, int sensor_winding,
           device::ThermometerRole thermometer = device::ThermometerRole::kNone) noexcept;

  /// One tick later. The gravest reason to stop now in this state, or kNone.
  Reason step(const WatchdogInputs& inputs) noexcept;

  /// Why an armed ball would stop at once, or kNone: the thermistor, currents and the fan as they
  /// are now. Faults that the board latches are for the board to clear.
  Reason doubt() const noexcept;

  const SensorCheck& sensor() const noexcept { return sensor_; }
  const BoardCheck& board() const noexcept { return board_; }
  const HeatCheck& heat() const noexcept { return heat_; }
  const FanCheck& fan() const noexcept { return fan_; }
  const ThermometerCheck& thermometer() const noexcept { return thermometer_; }
  /// The board has just been armed: fan and mode get their patience again.
  void begin_armed() noexcept {
    fan_.reset();
    board_.expect_armed();
  }

 private:
  int sensor_winding_ = 0;
  double unread_s_ = 0.0;  // since the last telemetry
  SensorCheck sensor_;
  HeatCheck heat_;
  CurrentCheck current_;
  FanCheck fan_;
  ThermometerCheck thermometer_;
  BoardCheck board_;
};

}  // namespace hedgehog::control

// SPDX-License-Identifier: MIT
// The second layer of safety: everything that must stop the ball whatever the limiter thinks
// (daemon/safety.md). Uses the raw thermistor and its own filtered V/I only.
#pragma once

#include "daemon/control/checks/board_check.h"
#include "daemon/control/checks/current_check.h"
#include "daemon/control/checks/fan_check.h"
#include "daemon/control/checks/over_temperature_check.h"
#include "daemon/control/checks/supply_balance.h"
#include "daemon/control/checks/telemetry_pair.h"
#include "daemon/control/checks/thermistor_check.h"
#include "daemon/control/checks/thermometer_check.h"
#include "daemon/control/state/state.h"
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
  /// The board has been asked to give up its latch.
  bool arming = false;
  model::Tick now = 0;
  device::ThermometerSample thermometer;
};

/// Control thread; real-time safe, trivially copyable.
class Watchdog {
 public:
  Watchdog() noexcept = default;
  Watchdog(const model::CoilModel& coils, const model::ThermalModel& thermal,
           device::ThermometerRole thermometer = device::ThermometerRole::kNone) noexcept;

  /// The ball starts at one temperature, that of its thermistors.
  void start_rested() noexcept { heat_.start_rested(); }

  /// The windings are other ones, of the same device file.
  void forget_windings(const model::CoilModel& coils, const model::ThermalModel& thermal) noexcept {
    heat_ = OverTemperatureCheck(coils, thermal);
    supply_ = SupplyBalance(coils.supply_v);
  }

  /// One tick later. The gravest reason to stop now in this state, or kNone.
  Reason step(const WatchdogInputs& inputs) noexcept;

  /// Why an armed ball would stop at once, or kNone: the thermistor, currents and the fan as they
  /// are now. Faults that the board latches are for the board to clear.
  Reason arming_blocker() const noexcept;

  const ThermistorCheck& sensor() const noexcept { return sensor_; }
  const BoardCheck& board() const noexcept { return board_; }
  const OverTemperatureCheck& heat() const noexcept { return heat_; }
  const FanCheck& fan() const noexcept { return fan_; }
  const ThermometerCheck& thermometer() const noexcept { return thermometer_; }
  const SupplyBalance& supply() const noexcept { return supply_; }
  /// What contradicts what, of the last kMeasurementsDisagree.
  const Disagreement& disagreement() const noexcept { return disagreement_; }
  /// The thermistors that can be read, by winding.
  const model::ThermistorReadings& thermistors() const noexcept { return thermistors_; }
  /// The board has just been armed: fan and mode get their patience again.
  void begin_armed() noexcept {
    fan_.reset();
    board_.expect_armed();
  }

 private:
  SensorReading sensor_reading(const WatchdogInputs& in, double since_s) const noexcept;
  HeatReading heat_reading(const WatchdogInputs& in, double since_s) const noexcept;
  CurrentReading current_reading(const WatchdogInputs& in, double since_s) const noexcept;
  Disagreement judge_supply(const WatchdogInputs& in, double dt_s) noexcept;

  int sensor_winding_ = 0;
  model::ThermistorReadings thermistors_;
  SupplyBalance supply_;
  Disagreement disagreement_;
  double unread_s_ = 0.0;  // since the last telemetry
  ThermistorCheck sensor_;
  OverTemperatureCheck heat_;
  CurrentCheck current_;
  FanCheck fan_;
  ThermometerCheck thermometer_;
  BoardCheck board_;
};

}  // namespace hedgehog::control

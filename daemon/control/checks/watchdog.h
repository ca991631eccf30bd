// SPDX-License-Identifier: MIT
// The second layer of safety: all conditions that must stop the ball regardless of the limiter
// (daemon/safety.md). Uses only the raw thermistors and its own filtered V/I.
#pragma once

#include <array>

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

/// Inputs of the watchdog for one tick. Made and used on the control thread.
struct WatchdogInputs {
  bool board_present = false;
  bool fresh = false;
  const device::BoardTelemetry& board;
  const TelemetryPair& pair;
  const device::BoardCommand& commanded;  // the set-point of the last tick
  double trip_c = 70.0;
  model::Tick ticks = 1;  // since the last step, 1 or more
  bool armed = true;      // if false, only the reasons that stop the ball in every state count
  bool arming = false;    // the board has been requested to clear its latch
  model::Tick now = 0;
  device::ThermometerSample thermometer;
};

/// Control thread; real-time safe, trivially copyable.
class Watchdog {
 public:
  Watchdog() noexcept = default;
  Watchdog(const model::CoilModel& coils, const model::ThermalModel& thermal,
           device::ThermometerRole thermometer = device::ThermometerRole::kNone) noexcept;

  /// The ball starts at a uniform temperature, that of its thermistors.
  void start_rested() noexcept { heat_.start_rested(); }

  /// The windings have been replaced by others of the same device file.
  void reset_windings(const model::CoilModel& coils, const model::ThermalModel& thermal) noexcept {
    heat_ = OverTemperatureCheck(coils, thermal);
    supply_ = SupplyBalance(coils.supply_v);
  }

  /// Advances by one tick. The gravest reason to stop in this state, or kNone.
  Reason step(const WatchdogInputs& inputs) noexcept;

  /// The reason for which an armed ball would stop at once, or kNone: the thermistor, currents and
  /// the second thermometer as they are now. Only the board clears the faults that it latches.
  Reason arming_blocker() const noexcept;

  /// The thermistor that the device file specifies.
  const ThermistorCheck& sensor() const noexcept { return thermistor(sensor_winding_); }
  /// That of winding `coil`; never usable where the board has none.
  const ThermistorCheck& thermistor(int coil) const noexcept {
    return thermistor_checks_[static_cast<std::size_t>(coil)];
  }
  const BoardCheck& board() const noexcept { return board_; }
  const OverTemperatureCheck& heat() const noexcept { return heat_; }
  const FanCheck& fan() const noexcept { return fan_; }
  const ThermometerCheck& thermometer() const noexcept { return thermometer_; }
  const SupplyBalance& supply() const noexcept { return supply_; }
  /// The contradicting quantities of the last kMeasurementsDisagree.
  const Disagreement& disagreement() const noexcept { return disagreement_; }
  /// The valid thermistor readings, by winding.
  const model::ThermistorReadings& thermistors() const noexcept { return thermistors_; }
  /// The board has just been armed: restarts the hold times of fan and mode.
  void begin_armed() noexcept {
    fan_.reset();
    board_.expect_armed();
  }

 private:
  /// The thermistor of winding `coil`.
  SensorReading sensor_reading(const WatchdogInputs& in, int coil, double since_s) const noexcept;
  HeatReading heat_reading(const WatchdogInputs& in, double since_s) const noexcept;
  CurrentReading current_reading(const WatchdogInputs& in, double since_s) const noexcept;
  Disagreement check_supply(const WatchdogInputs& in, double dt_s) noexcept;
  /// The thermistors besides that of `sensor()`, on boards with several.
  Disagreement check_other_thermistors(const WatchdogInputs& in, double since_s,
                                       double dt_s) noexcept;

  int sensor_winding_ = 0;
  int thermistor_count_ = 1;  // 1, on `sensor_winding_`, or one on each of the first windings
  model::ThermistorReadings thermistors_;
  SupplyBalance supply_;
  Disagreement disagreement_;
  double since_fresh_s_ = 0.0;  // since the last telemetry
  std::array<ThermistorCheck, model::kCoils> thermistor_checks_{};
  OverTemperatureCheck heat_;
  CurrentCheck current_;
  FanCheck fan_;
  ThermometerCheck thermometer_;
  BoardCheck board_;
};

}  // namespace hedgehog::control

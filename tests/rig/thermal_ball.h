// SPDX-License-Identifier: MIT
// The thermal part of all layers, closed around a ball and its electronics in steps of 20 ms: for
// thousands of hours. Currents follow at once; readings have the electronics' errors. The whole rig
// (rig.h) is the reference for anything faster.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "daemon/control/checks/estimate_check.h"
#include "daemon/control/checks/fan_check.h"
#include "daemon/control/checks/over_temperature_check.h"
#include "daemon/control/checks/supply_balance.h"
#include "daemon/control/checks/thermistor_check.h"
#include "daemon/control/state/disagreement.h"
#include "daemon/device/simulator/simulated_board.h"
#include "daemon/device/simulator/simulator_errors.h"
#include "model/estimate/skin_estimate.h"
#include "model/estimate/thermal_observer.h"
#include "model/limit/thermal_limiter.h"
#include "model/thermal/fan.h"

namespace hedgehog::rig {

struct ThermalBallOptions {
  device::SimulatedBoardOptions board;
  /// The daemon's parameters: its device file.
  model::CoilModel coils;
  model::ThermalModel thermal;
  model::ThermalUncertainty uncertainty;
  /// The daemon starts with the ball known to be at one temperature; otherwise with an unknown one.
  bool known = true;
  /// The estimated skin temperature limits the current. False: as with a probe under a shell that
  /// insulates well, which is the worse case for the windings.
  bool skin_limits = false;
  std::uint64_t seed = 1;
};

/// Why a ball stopped.
struct Stop {
  control::Reason reason = control::Reason::kNone;
  control::Disagreement disagreement;

  bool any() const noexcept { return reason != control::Reason::kNone; }
};

class ThermalBall {
 public:
  static constexpr double kStepS = 0.02;

  explicit ThermalBall(const ThermalBallOptions& options) noexcept;

  void set_errors(const device::SimulatorErrorList& errors) noexcept { errors_.set(errors); }
  /// One step; `peak_a` is scaled by the limiter, `rms` of that heats. After a stop nothing is
  /// driven.
  void step(const model::Vec3& peak_a, double rms = 1.0) noexcept;

  /// Arms the ball again after any stop.
  void rearm() noexcept { stop_ = {}; }

  const Stop& stop() const noexcept { return stop_; }
  const model::Plant& plant() const noexcept { return plant_; }
  const model::ThermalObserver& observer() const noexcept { return observer_; }
  const model::SkinEstimate& skin() const noexcept { return skin_; }
  const control::SupplyBalance& supply() const noexcept { return supply_; }
  const control::OverTemperatureCheck& heat() const noexcept { return heat_; }
  double allowed_a() const noexcept { return limiter_.allowed().value; }
  /// True if the current was less than requested.
  bool reduced() const noexcept { return reduced_; }
  const model::Vec3& current_a() const noexcept { return current_a_; }

 private:
  model::ThermistorReadings read_thermistors() noexcept;
  /// The thermistor of `coil` against its V/I.
  control::Reason check_thermistor(const model::ThermalMeasurement& measurement, int coil) noexcept;
  Stop check_thermistors(const model::ThermalMeasurement& measurement) noexcept;
  void run_checks(const model::ThermalMeasurement& measurement, const model::Vec3& duty,
                  double supply_current_a, double supply_v, control::Reason fan) noexcept;

  model::CoilModel coils_;
  model::ThermalModel thermal_;
  model::Plant plant_;
  device::FrontEndParameters built_;
  device::SimulatorErrors errors_;
  model::CurrentAccuracy accuracy_;
  model::RandomStream random_;
  model::ThermalObserver observer_;
  model::ThermalLimiter limiter_{model::Limits{}};
  model::SkinEstimate skin_;
  bool skin_limits_ = false;
  std::array<control::ThermistorCheck, model::kCoils> thermistor_checks_{};
  control::OverTemperatureCheck heat_;
  control::EstimateCheck estimate_;
  control::SupplyBalance supply_;
  model::Fan fan_;
  control::FanCheck fan_check_;
  double fan_duty_ = 0.0;
  std::uint8_t conversions_ = 0;
  bool reduced_ = false;
  model::Vec3 current_a_;
  Stop stop_;
};

/// "measurements_disagree (winding y: resistance, heat_balance)".
std::string words(const Stop& stop);

/// A ball drawn from all healthy ones: R25 within 3 %, gains within 2 %, offsets within 0.02 A
/// (`in_line`) or 0.1 A, supply within 2 %, thermistors within 1 K, thermal constants within
/// `thermal_tolerance`, with which the daemon is configured, at 18..32 C ambient.
ThermalBallOptions family_ball(std::uint64_t seed, const device::FrontEndChoice& front_end,
                               double thermal_tolerance) noexcept;

}  // namespace hedgehog::rig

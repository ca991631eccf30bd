// SPDX-License-Identifier: MIT
// Simulated plant: three windings with resistance and inductance, thermal network, thermistor, fan,
// pins and ambient, for the simulated board and fault campaigns. Constants: model/thermal-model.md.
#pragma once

#include <array>
#include <cstdint>

#include "model/calibration.h"
#include "model/coils.h"
#include "model/geometry/pin_motion.h"
#include "model/random_stream.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// One ball and its surroundings; any constant may differ from nominal. Trivially copyable.
struct PlantParameters {
  std::array<double, kCoils> winding_j_k{58.81, 58.81, 58.81};
  double core_j_k = 84.4;
  std::array<double, kCoils> winding_to_core_k_w{1.0, 1.0, 1.0};
  double core_to_ambient_fan_k_w = 1.8;    // fan at full speed
  double core_to_ambient_still_k_w = 5.0;  // fan stopped; conductance is linear in its speed
  std::array<double, kCoils> r25_ohm{0.45, 0.45, 0.45};
  double inductance_h = 1.5e-3;
  double freewheel_v = 0.8;  // opposes the current while a bridge sleeps and the winding freewheels
  double supply_v = 12.0;
  int sensor_winding = 0;
  double sensor_lag_s = 2.0;
  double sensor_noise_k = 0.0;  // standard deviation of one reading
  double fan_full_rpm = 7200.0;
  double fan_spin_up_s = 1.0;
  double skin_share = 0.7;  // of the way from ambient to core, in the steady state
  double skin_lag_s = 60.0;
  Mat3 coil_matrix;                                               // true CoilModel::matrix
  double force_slope_n_a = kMeasuredCalibration.force_slope_n_a;  // on a pin aimed at
  std::uint64_t seed = 1;                                         // of the noise

  /// The ball that matches its device file.
  static PlantParameters of(const CoilModel& coils, const ThermalModel& thermal) noexcept;
};

/// Changes of a ball since it was built. Trivially copyable.
struct PlantErrors {
  std::array<double, kCoils> resistance_gain{1.0, 1.0, 1.0};  // R25 relative to the parameters'
  std::array<double, kCoils> shorted_turns{};  // share: R decreases with it, L with its square
  std::array<double, kCoils> lost_contact{};   // share by which a thermistor follows the core
  double cooling_gain = 1.0;                   // of the conductance from core to ambient
  double heat_capacity_gain = 1.0;             // of all nodes
};

/// Connection of one winding during a step.
enum class BridgeState : std::uint8_t {
  kAsleep,  // SLP low: the winding freewheels through the diodes
  kDriven,  // the mean voltage is applied; 0 V is a brake
  kOpen,    // a broken wire: no current at all
};

/// Trivially copyable.
struct PlantInputs {
  std::array<BridgeState, kCoils> bridge{BridgeState::kAsleep, BridgeState::kAsleep,
                                         BridgeState::kAsleep};
  Vec3 voltage_v;            // mean bridge voltage (duty x supply); only for driven windings
  double fan_duty = 0.0;     // 0..1
  bool fan_stopped = false;  // seized: it spins down at any duty
};

/// Real-time safe, trivially copyable, deterministic.
class Plant {
 public:
  Plant() noexcept : Plant(PlantParameters{}, 25.0) {}
  /// Everything at `ambient_c`, no current, fan stopped.
  Plant(const PlantParameters& parameters, double ambient_c) noexcept;

  /// `dt_s`: a tick of 1 ms, at most 20 ms. Currents are exact for a constant voltage within it.
  void step(const PlantInputs& inputs, double dt_s) noexcept;

  /// Heat only, for campaigns: `dt_s` at most 100 ms. The currents are unchanged.
  void step_thermal(const Vec3& mean_square_a2, double fan_duty, double dt_s) noexcept;

  /// Of the windings at the end of the last step, and the mean of their squares over it.
  const Vec3& current_a() const noexcept { return current_a_; }
  const Vec3& mean_square_a2() const noexcept { return mean_square_a2_; }
  double sensor_c() const noexcept { return reading_c_; }  // last reading, with lag and noise
  /// The same without noise; and that of a thermistor on winding `coil`.
  double sensor_body_c() const noexcept { return thermistor_c(parameters_.sensor_winding); }
  double thermistor_c(int coil) const noexcept {
    return thermistor_c_[static_cast<std::size_t>(coil)];
  }
  double skin_c() const noexcept { return skin_c_; }  // at the hand
  double fan_rpm() const noexcept { return fan_speed_ * parameters_.fan_full_rpm; }
  const ThermalState& heat() const noexcept { return heat_; }
  double hottest_winding_c() const noexcept;
  double resistance_ohm(int coil) const noexcept;  // at its present temperature
  double ambient_c() const noexcept { return ambient_c_; }
  /// Pin forces and displacements by the true currents. Allocates: not in a step.
  PinMotion pins(const PinArray& array, const PinCurves& curves) const;
  const PlantParameters& parameters() const noexcept { return parameters_; }

  void set_ambient(double ambient_c) noexcept { ambient_c_ = ambient_c; }
  void set_supply(double supply_v) noexcept { parameters_.supply_v = supply_v; }
  void set_errors(const PlantErrors& errors) noexcept { errors_ = errors; }
  /// Warm start: thermistors at their windings' temperatures, skin settled.
  void set_heat(const ThermalState& heat) noexcept;

 private:
  void step_winding(int coil, BridgeState bridge, double voltage_v, double dt_s) noexcept;
  void step_fan(double duty, double dt_s) noexcept;
  void step_heat(double dt_s) noexcept;  // in substeps as required by the fastest node
  void step_nodes(double dt_s) noexcept;
  double to_ambient_w_k() const noexcept;
  double fastest_per_s() const noexcept;  // rate of the fastest node alone
  void step_thermistors(double dt_s) noexcept;
  double inductance_h(std::size_t coil) const noexcept;

  PlantParameters parameters_;
  PlantErrors errors_;
  RandomStream noise_;
  Vec3 current_a_;
  Vec3 mean_square_a2_;
  ThermalState heat_;
  double ambient_c_ = 25.0;
  std::array<double, kCoils> thermistor_c_{25.0, 25.0, 25.0};
  double skin_c_ = 25.0;
  double reading_c_ = 25.0;
  double fan_speed_ = 0.0;
};

}  // namespace hedgehog::model

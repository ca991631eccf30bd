// SPDX-License-Identifier: MIT
// Temperatures of the windings and their upper bounds, by energy balance, V/I and thermistors: a
// Kalman filter's estimate plus its uncertainty, and lower limits of that bound which do not depend
// on the filter. Fault detection: daemon/failures.md.
#pragma once

#include <array>
#include <limits>

#include "model/coils.h"
#include "model/estimate/energy_floor.h"
#include "model/estimate/resistance_fall.h"
#include "model/estimate/thermal_filter.h"
#include "model/estimate/thermistor_lead.h"
#include "model/estimate/winding_thermometer.h"
#include "model/thermal/thermal_flow.h"
#include "model/thermal/thermal_model.h"
#include "model/thermal/thermal_uncertainty.h"
#include "model/tick.h"

namespace hedgehog::model {

/// One millisecond of measurements. Trivially copyable.
struct ThermalMeasurement {
  /// Mean bridge voltages (duty x supply), and currents at start and end, of the same tick: one
  /// tick off is an error of tens of kelvins while the current changes. After a lost frame clear
  /// `electrical_valid`.
  Vec3 voltage_v;
  Vec3 current_before_a;
  Vec3 current_a;
  double supply_v = 0.0;  // at the bridges; 0: not measured
  /// False when the bridges were asleep or the telemetry was lost: V/I is then not measured, and
  /// currents are zero or assumed.
  bool electrical_valid = false;
  std::array<bool, kCoils> current_measured{true, true, true};  // false: it is a prediction
  bool idle = false;  // no current can flow and the current sensors are read
  Vec3 idle_a;        // their readings
  CurrentAccuracy accuracy;
  ThermistorReadings thermistors;  // not valid while absent, open, shorted, stale, out of range
  bool fan_running = false;
};

/// Initial state of an observer. Trivially copyable.
struct ThermalStart {
  ThermalState nodes;
  /// NaN: the coolest node if it is below 35 C, else 25 C.
  double ambient_c = std::numeric_limits<double>::quiet_NaN();
  /// The nodes are a previous estimate or ambient temperature; false: guessed by the thermistor.
  bool known = false;
  double deviation_k = 0.3;  // of each node, in addition to the thermistors'; only if `known`
  std::array<bool, kCoils> measured{};  // by V/I since then

  /// True if the ball is at one temperature, so that its thermistors measure every winding.
  bool at_rest() const noexcept {
    return known && deviation_k <= kMaxRestDeviationK && at_one_temperature(nodes);
  }
  static constexpr double kMaxRestDeviationK = 1.0;
};

struct ThermalEstimate {
  ThermalState nodes;
  std::array<double, kCoils> deviation_k{};  // standard deviation of each winding's temperature
  std::array<double, kCoils> upper_c{25.0, 25.0, 25.0};  // upper bounds, for the limiter
  /// Maximum of those and of the thermistors with their lead; the limiter must use it. Infinity
  /// when no thermistor has been valid for 100 ms (until then its last value is held).
  double hottest_c = 25.0;
  double likely_c = 25.0;  // hottest winding's estimate plus a standard deviation; for the trip
  double sensor_lead_c = 25.0;  // thermistor with lead compensation
  double ambient_c = 25.0;      // effective: a badly cooled core appears as a warmer ambient
  /// Windings measured by V/I since the start (after a restart without saved temperatures a winding
  /// is limited to continuous_a until then), and at this tick.
  std::array<bool, kCoils> measured{};
  std::array<bool, kCoils> measuring{};
  /// Present resistances for the bridge voltages, within a factor of two of the filter's.
  std::array<double, kCoils> resistance_ohm{0.45, 0.45, 0.45};
};

/// Real-time safe; trivially copyable, so that the flight recorder can keep it.
class ThermalObserver {
 public:
  static constexpr double kWindowS = 0.1;  // update period of the filter

  ThermalObserver() noexcept : ThermalObserver(CoilModel{}, ThermalModel{}, ThermalStart{}) {}
  ThermalObserver(const CoilModel& coils, const ThermalModel& thermal, const ThermalStart& start,
                  const ThermalUncertainty& uncertainty = {}) noexcept;

  /// Advances by `dt_s` (a tick; up to 20 ms when ticks were skipped) with the measurements of its
  /// last millisecond. Non-finite numbers and currents above 100 A count as not measured.
  void step(const ThermalMeasurement& measurement, double dt_s = kTickSeconds) noexcept;
  const ThermalEstimate& estimate() const noexcept { return estimate_; }

  /// Innovations are those of the last window; `window_ended()`: it ended in this tick.
  const ThermalFilter& filter() const noexcept { return filter_; }
  bool window_ended() const noexcept { return window_ended_; }
  struct WindowInnovations {
    bool resistance_known = false;
    Innovation resistance;
    bool thermistor_known = false;
    Innovation thermistor;
  };
  const WindowInnovations& innovations(int coil) const noexcept {
    return innovations_[static_cast<std::size_t>(coil)];
  }
  const ResistanceFall& fall(int coil) const noexcept {
    return fall_[static_cast<std::size_t>(coil)];
  }
  const WindingThermometer& winding(int coil) const noexcept {
    return thermometer_[static_cast<std::size_t>(coil)];
  }
  const ThermistorReadings& thermistors() const noexcept { return thermistors_; }
  /// True within 20 s of a start from unknown temperatures: no fault detection yet.
  bool settling() const noexcept { return settling_s_ > 0.0; }

 private:
  struct Window {  // sums over the current one
    double s = 0.0;
    std::array<double, kCoils> heat_j{};
    int ticks = 0;
    std::array<int, kCoils> idle_ticks{};
    Vec3 idle_a_sum;
    std::array<int, kCoils> thermistor_ticks{};
    std::array<double, kCoils> thermistor_sum{};
    std::array<bool, kCoils> always_measured{true, true, true};
  };

  void follow_currents(const ThermalMeasurement& measurement, double dt_s) noexcept;
  void follow_thermistors(const ThermistorReadings& thermistors, double dt_s) noexcept;
  void end_window(bool fan_running) noexcept;
  void take_from_filter() noexcept;
  void correct_winding(int coil) noexcept;
  double margin_k(int coil) const noexcept;
  void bound() noexcept;
  double resistance_ohm(int coil) const noexcept;
  double likely_c(int coil) const noexcept;
  double bound_by_filter(int coil) const noexcept;
  double floor_by_resistance(int coil) const noexcept;
  void follow_supply(const ThermalMeasurement& measurement, double dt_s) noexcept;
  double supply_error_k(int coil) const noexcept;

  CoilModel coils_;
  ThermalModel thermal_;
  ThermalEstimate estimate_;
  ThermalFilter filter_;
  std::array<double, kCoils> expected_ohm_{};  // the filter's, at the end of the last window
  EnergyFloor floor_;
  std::array<WindingThermometer, kCoils> thermometer_{};
  CurrentAccuracy accuracy_;
  Window window_;
  std::array<WindowInnovations, kCoils> innovations_{};
  std::array<ResistanceFall, kCoils> fall_{};
  std::array<double, kCoils> per_ampere_{};  // fall of ln R per ampere of offset, last window
  bool window_ended_ = false;
  double settling_s_ = 0.0;
  Vec3 mean_square_a2_;  // of the winding currents over the last step; kept while unknown
  ThermistorReadings thermistors_;
  double supply_v_ = 0.0;                            // no-load, low-pass filtered
  std::array<double, kCoils> reference_supply_v_{};  // the same at each last reference
  ThermistorLead sensor_;
};

}  // namespace hedgehog::model

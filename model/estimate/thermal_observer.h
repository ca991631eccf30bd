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
  /// Mean bridge voltages over it (duty x supply), and currents at its start and end. They must be
  /// of the same tick: a voltage one tick off causes an error of tens of kelvins while the current
  /// changes. After a lost frame set `electrical_valid` to false.
  Vec3 voltage_v;
  Vec3 current_before_a;
  Vec3 current_a;
  /// At the bridges, V; 0: not measured.
  double supply_v = 0.0;
  /// False when the bridges were asleep or the telemetry was lost: V/I is then not measured, and
  /// currents are zero or assumed.
  bool electrical_valid = false;
  /// By winding: false when its current is a prediction, not a measurement.
  std::array<bool, kCoils> current_measured{true, true, true};
  /// True when no current can flow and the sensors are read; `idle_a`: their readings.
  bool idle = false;
  Vec3 idle_a;
  CurrentAccuracy accuracy;
  /// By winding; not valid where there is none, or while it is open, shorted, stale or out of
  /// range.
  ThermistorReadings thermistors;
  bool fan_running = false;
};

/// Initial state of an observer. Trivially copyable.
struct ThermalStart {
  ThermalState nodes;
  /// NaN: use the coolest node if it is below 35 C, else 25 C.
  double ambient_c = std::numeric_limits<double>::quiet_NaN();
  /// True if the nodes come from a previous estimate or from a ball at ambient temperature;
  /// otherwise they are a guess from the thermistor.
  bool known = false;
  /// Standard deviation of each node in addition to that of the thermistors, K; only if `known`.
  double deviation_k = 0.3;
  /// Windings measured by V/I since then.
  std::array<bool, kCoils> measured{};

  /// True if the ball is at one temperature, so that its thermistors measure every winding.
  bool at_rest() const noexcept {
    return known && deviation_k <= kMaxRestDeviationK && at_one_temperature(nodes);
  }
  static constexpr double kMaxRestDeviationK = 1.0;
};

struct ThermalEstimate {
  ThermalState nodes;
  /// Standard deviation of each winding's temperature, K.
  std::array<double, kCoils> deviation_k{};
  /// Upper bound of each winding's temperature, C; used by the limiter.
  std::array<double, kCoils> upper_c{25.0, 25.0, 25.0};
  /// Maximum of those and of the thermistors with their lead; the limiter must use it. Infinity
  /// when no thermistor has been valid for 100 ms (until then its last value is held).
  double hottest_c = 25.0;
  /// Estimate of the hottest winding plus one standard deviation, C; used for the trip.
  double likely_c = 25.0;
  /// Thermistor with lead compensation, C.
  double sensor_lead_c = 25.0;
  /// Estimated ambient temperature. An effective value: a core cooled worse than nominal appears as
  /// a warmer ambient.
  double ambient_c = 25.0;
  /// Windings measured by V/I since the start (after a restart without saved temperatures a winding
  /// is limited to continuous_a until then).
  std::array<bool, kCoils> measured{};
  /// Windings measured by V/I at this tick.
  std::array<bool, kCoils> measuring{};
  /// Estimated resistance of each winding now, ohm, within a factor of two of the filter's; for
  /// the bridge voltage.
  std::array<double, kCoils> resistance_ohm{0.45, 0.45, 0.45};
};

/// Real-time safe; trivially copyable, so that the flight recorder can keep it.
class ThermalObserver {
 public:
  /// Update period of the filter.
  static constexpr double kWindowS = 0.1;

  ThermalObserver() noexcept : ThermalObserver(CoilModel{}, ThermalModel{}, ThermalStart{}) {}
  ThermalObserver(const CoilModel& coils, const ThermalModel& thermal, const ThermalStart& start,
                  const ThermalUncertainty& uncertainty = {}) noexcept;

  /// Advances by `dt_s` (a tick; up to 20 ms when ticks were skipped) with the measurements of its
  /// last millisecond. Non-finite numbers and currents above 100 A count as not measured.
  void step(const ThermalMeasurement& measurement, double dt_s = kTickSeconds) noexcept;
  const ThermalEstimate& estimate() const noexcept { return estimate_; }

  /// The filter, and the innovations of the last window's measurements; `window_ended()`: true in
  /// the tick in which a window ended.
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
  /// Of the last step.
  const ThermistorReadings& thermistors() const noexcept { return thermistors_; }
  /// True within 20 s of a start from unknown temperatures: no fault detection yet.
  bool settling() const noexcept { return settling_s_ > 0.0; }

 private:
  /// Sums over the current window.
  struct Window {
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
  /// The filter's resistances: they, too, change at the end of a window only.
  std::array<double, kCoils> expected_ohm_{};
  EnergyFloor floor_;
  std::array<WindingThermometer, kCoils> thermometer_{};
  CurrentAccuracy accuracy_;
  Window window_;
  std::array<WindowInnovations, kCoils> innovations_{};
  std::array<ResistanceFall, kCoils> fall_{};
  /// Decrease of ln R per ampere of current offset in the last window.
  std::array<double, kCoils> per_ampere_{};
  bool window_ended_ = false;
  double settling_s_ = 0.0;
  /// Mean squares of the winding currents over the last step, A^2; kept while unknown.
  Vec3 mean_square_a2_;
  ThermistorReadings thermistors_;
  /// No-load supply voltage: low-pass filtered, and at each winding's last reference, V.
  double supply_v_ = 0.0;
  std::array<double, kCoils> reference_supply_v_{};
  ThermistorLead sensor_;
};

}  // namespace hedgehog::model

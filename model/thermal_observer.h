// SPDX-License-Identifier: MIT
// What the windings' temperatures are, from everything that is known: each winding's own resistance
// (V/I, valid above 1.5 A), the heat model in between, and the one thermistor. DESIGN section 6,
// "Knowing the temperature".
#pragma once

#include <array>

#include "model/coils.h"
#include "model/thermal_model.h"
#include "model/thermal_winding_meter.h"
#include "model/tick.h"

namespace hedgehog::model {

/// One millisecond of measurements. Trivially copyable.
struct ThermalMeasurement {
  /// Mean bridge voltages over it (duty x supply), and currents at its start and end. They
  /// must belong together: a voltage that is one tick off reads as tens of kelvins while the
  /// current changes. After a lost frame say `electrical_valid` false.
  Vec3 voltage_v;
  Vec3 current_before_a;
  Vec3 current_a;
  /// False when the bridges slept or the telemetry did not arrive: then V/I says nothing, and
  /// currents are zero or assumed.
  bool electrical_valid = false;
  /// The thermistor; not valid when open, short, stale or impossible.
  double sensor_c = 0.0;
  bool sensor_valid = false;
  bool fan_running = false;
};

struct ThermalEstimate {
  ThermalState nodes;
  /// max(windings, sensor with 2 s lead): what the limiter must use. Infinity when nothing can be
  /// trusted: the thermistor has said nothing valid for 100 ms (before that, its last value stays).
  double hottest_c = 25.0;
  /// The thermistor with its lead, and what it ought to show by the estimate of its own winding.
  double sensor_lead_c = 25.0;
  double expected_sensor_c = 25.0;
  /// Estimated room temperature. "As felt": a core that is cooled worse than nominal looks like a
  /// warmer room.
  double room_c = 25.0;
  /// Which windings have been measured by their own V/I since the start (after a restart without
  /// saved temperatures a winding is held to continuous_a until then).
  std::array<bool, kCoils> measured{};
  /// Which windings are being measured by their own V/I at this tick.
  std::array<bool, kCoils> measuring{};
  /// Estimated resistance of each winding now, ohm; for the bridge voltage.
  std::array<double, kCoils> resistance_ohm{0.45, 0.45, 0.45};
};

/// Real-time safe; trivially copyable, so that the flight recorder can keep it.
class ThermalObserver {
 public:
  ThermalObserver() noexcept : ThermalObserver(CoilModel{}, ThermalModel{}, ThermalState{}) {}
  /// The room is taken for the coolest node of `start` when that is below 35 C, else for 25 C.
  ThermalObserver(const CoilModel& coils, const ThermalModel& thermal,
                  const ThermalState& start) noexcept;

  /// `dt_s` later (a tick; up to 20 ms when ticks were skipped), with what was measured in its last
  /// millisecond. Numbers that are not finite, or currents above 100 A, count as not measured.
  void step(const ThermalMeasurement& measurement, double dt_s = kTickSeconds) noexcept;
  const ThermalEstimate& estimate() const noexcept { return estimate_; }
  /// The start values of these windings go back to a measurement of theirs, so they need no hold to
  /// continuous_a.
  void trust_start(const std::array<bool, kCoils>& measured) noexcept {
    estimate_.measured = measured;
  }
  /// The room as saved before a restart.
  void set_room(double room_c) noexcept { estimate_.room_c = room_c; }

 private:
  void predict(const ThermalMeasurement& measurement, double dt_s) noexcept;
  void correct_by_resistance(const ThermalMeasurement& measurement, bool electrical_valid,
                             double dt_s) noexcept;
  void correct_by_sensor(double dt_s) noexcept;
  void follow_sensor(const ThermalMeasurement& measurement, double dt_s) noexcept;
  void correct_core(double core_error_k, double core_tau_s, double dt_s) noexcept;
  void correct_room(double rate_k_s, double dt_s) noexcept;

  CoilModel coils_;
  ThermalModel thermal_;
  ThermalEstimate estimate_;
  std::array<WindingMeter, kCoils> meter_;
  /// Mean squares of the winding currents over the last step, A^2; kept while unknown.
  Vec3 mean_square_a2_;
  double sensor_fast_c_ = 25.0;
  double sensor_slow_c_ = 25.0;
  double sensor_silent_s_ = 0.0;
  bool sensor_seen_ = false;
};

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// What the windings' temperatures are, from everything that is known: each winding's own resistance
// (V/I, valid above 1.5 A), the heat model in between, and the one thermistor. DESIGN section 6,
// "Knowing the temperature".
#pragma once

#include <array>

#include "model/coils.h"
#include "model/thermal_model.h"

namespace hedgehog::model {

/// One tick of measurements. Trivially copyable.
struct ThermalMeasurement {
  /// Mean bridge voltages over the tick (duty x supply), and currents at its start and end.
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
  /// trusted.
  double hottest_c = 25.0;
  /// The thermistor with its lead, and what it ought to show by the estimate of its own winding.
  double sensor_lead_c = 25.0;
  double expected_sensor_c = 25.0;
  /// Estimated room temperature.
  double room_c = 25.0;
  /// Which windings have been measured by their own V/I since the start (after a restart without
  /// saved temperatures a winding is held to continuous_a until then).
  std::array<bool, kCoils> measured{};
  /// Estimated resistance of each winding now, ohm; for the bridge voltage.
  std::array<double, kCoils> resistance_ohm{0.45, 0.45, 0.45};
};

/// Real-time safe; trivially copyable, so that the flight recorder can keep it.
class ThermalObserver {
 public:
  ThermalObserver() noexcept = default;
  ThermalObserver(const CoilModel& coils, const ThermalModel& thermal,
                  const ThermalState& start) noexcept;

  /// One tick later, with what was measured in it.
  void step(const ThermalMeasurement& measurement) noexcept;
  const ThermalEstimate& estimate() const noexcept { return estimate_; }
  /// The start values were measured by the sensor, not guessed: marks windings as not needing the 5
  /// A hold.
  void trust_start() noexcept { estimate_.measured = {true, true, true}; }

 private:
  CoilModel coils_;
  ThermalModel thermal_;
  ThermalEstimate estimate_;
  std::array<double, kCoils> filtered_resistance_{};
  std::array<double, kCoils> filter_weight_{};
  double sensor_filtered_c_ = 25.0;
  double sensor_slow_c_ = 25.0;
  bool sensor_seen_ = false;
};

}  // namespace hedgehog::model

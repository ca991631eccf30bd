// SPDX-License-Identifier: MIT
// A winding as a resistance thermometer: V/I relative to the resistance at the last rest, when a
// thermistor measured its temperature. Constant gain errors of voltage and current and an error of
// the device file's R25 cancel.
#pragma once

#include "model/coils.h"
#include "model/estimate/thermal_winding_meter.h"
#include "model/estimate/thermistor_readings.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// Inputs of a winding thermometer in one tick. Trivially copyable.
struct WindingReading {
  double voltage_v = 0.0;
  /// Currents at the start and end of the last millisecond; `measured`: true with a voltage of the
  /// same tick.
  double before_a = 0.0;
  double after_a = 0.0;
  bool measured = false;
  /// Copper loss in this tick, W, also while not measured.
  double loss_w = 0.0;
  /// The thermistor that is at the winding's temperature once the winding has rested.
  ThermistorReference reference;
};

/// Real-time safe, trivially copyable. Detects by a model of its heating when the winding has
/// rested, i.e. its heat has gone into the core.
class WindingThermometer {
 public:
  WindingThermometer() noexcept : WindingThermometer(CoilModel{}, ThermalModel{}, 0) {}
  /// Winding `coil`, 0..2.
  WindingThermometer(const CoilModel& coils, const ThermalModel& thermal, int coil) noexcept;

  void set_accuracy(const CurrentAccuracy& accuracy) noexcept { meter_.set_accuracy(accuracy); }
  /// Starts at the temperature of its reference.
  void start_rested() noexcept { above_k_ = 0.0; }

  /// True if it is at the temperature of its surroundings.
  bool rested() const noexcept { return above_k_ < kRestedK; }

  /// Advances by `dt_s`, at most 20 ms.
  void step(const WindingReading& reading, double dt_s) noexcept;

  const WindingMeter& meter() const noexcept { return meter_; }
  /// True while V/I is measured.
  bool measuring() const noexcept { return meter_.valid(); }
  /// True at rest and while the current for the next reference is measured.
  bool comparing() const noexcept { return comparing_; }
  /// True if the last step completed a reference.
  bool reference_taken() const noexcept { return reference_taken_; }
  /// True if it has a measured reference, not only the device file's R25.
  bool referenced() const noexcept { return referenced_; }
  /// Resistance at 25 C by its reference (else by the device file), including this board's gain
  /// errors, ohm.
  double r25_ohm() const noexcept { return r25_ohm_; }
  /// Relative decrease of that per ampere of current offset.
  double reference_per_ampere() const noexcept { return reference_per_ampere_; }
  /// By V/I; before the first measurement the one at 25 C, ohm.
  double resistance_ohm() const noexcept {
    return meter_.resistance_ohm() > 0.0 ? meter_.resistance_ohm() : r25_ohm_;
  }
  /// By V/I; the last value while not measuring, 25 C before the first.
  double celsius() const noexcept;
  /// Three standard deviations of its noise, and its error by the current offset, K; only while
  /// measuring. The second considers that the reference has the same offset.
  double noise_k() const noexcept;
  double bias_k() const noexcept;

 private:
  void compare(const WindingReading& reading, double dt_s) noexcept;

  double joule_per_k_ = 58.81;
  double rest_s_ = 88.0;
  WindingMeter meter_;
  double r25_ohm_ = 0.45;
  bool referenced_ = false;
  double reference_per_ampere_ = 0.0;
  // Temperature above its surroundings, and warming since it was last at rest, K.
  double above_k_ = kUnknownK;
  double warmed_k_ = kUnknownK;
  double rest_c_ = 25.0;
  bool comparing_ = false;
  bool reference_taken_ = false;
  double weight_a2s_ = 0.0;
  double weighted_ohm_ = 0.0;
  double weighted_per_ampere_ = 0.0;

  static constexpr double kUnknownK = 40.0;
  static constexpr double kRestedK = 0.4;
};

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// A winding as a resistance thermometer: V/I relative to the resistance at the last rest beside a
// thermistor. Constant gain errors and an error of the device file's R25 cancel.
#pragma once

#include "model/coils.h"
#include "model/estimate/thermal_winding_meter.h"
#include "model/estimate/thermistor_readings.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// Inputs in one tick. Trivially copyable.
struct WindingReading {
  double voltage_v = 0.0;
  double before_a = 0.0;          // current at the start of the last millisecond
  double after_a = 0.0;           // and at its end
  bool measured = false;          // voltage and currents, of the same tick
  double loss_w = 0.0;            // copper loss in this tick, also while not measured
  ThermistorReference reference;  // has the winding's temperature once the winding has rested
};

/// Real-time safe, trivially copyable. Detects by a model of its heating when the winding has
/// rested, i.e. its heat has gone into the core.
class WindingThermometer {
 public:
  WindingThermometer() noexcept : WindingThermometer(CoilModel{}, ThermalModel{}, 0) {}
  WindingThermometer(const CoilModel& coils, const ThermalModel& thermal, int coil) noexcept;

  void set_accuracy(const CurrentAccuracy& accuracy) noexcept { meter_.set_accuracy(accuracy); }
  void start_rested() noexcept { above_k_ = 0.0; }  // at the temperature of its reference
  bool rested() const noexcept { return above_k_ < kRestedK; }  // as warm as its surroundings

  /// Advances by `dt_s`, at most 20 ms.
  void step(const WindingReading& reading, double dt_s) noexcept;

  const WindingMeter& meter() const noexcept { return meter_; }
  bool measuring() const noexcept { return meter_.valid(); }  // V/I is measured
  bool comparing() const noexcept { return comparing_; }  // at rest, or taking the next reference
  bool reference_taken() const noexcept { return reference_taken_; }  // by the last step
  bool referenced() const noexcept { return referenced_; }  // false: only the device file's R25
  /// By its reference, else by the device file; includes this board's gain errors.
  double r25_ohm() const noexcept { return r25_ohm_; }
  /// Relative decrease of that per ampere of current offset.
  double reference_per_ampere() const noexcept { return reference_per_ampere_; }
  /// By V/I; before the first measurement the one at 25 C.
  double resistance_ohm() const noexcept {
    return meter_.resistance_ohm() > 0.0 ? meter_.resistance_ohm() : r25_ohm_;
  }
  /// By V/I; the last value while not measuring, 25 C before the first.
  double celsius() const noexcept;
  /// Three standard deviations of its noise, and its error by the current offset, which the
  /// reference has too; only while measuring.
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
  double above_k_ = kUnknownK;   // above its surroundings
  double warmed_k_ = kUnknownK;  // since it was last at rest
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

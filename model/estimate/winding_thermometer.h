// SPDX-License-Identifier: MIT
// A winding as a resistance thermometer: V/I against the resistance at the last rest beside a
// thermistor. Constant gains of voltage and current cancel, and so does an error of the device
// file's R25.
#pragma once

#include "model/coils.h"
#include "model/estimate/thermal_winding_meter.h"
#include "model/estimate/thermistor_readings.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// One tick of what a winding thermometer sees. Trivially copyable.
struct WindingReading {
  double voltage_v = 0.0;
  /// Currents at the start and end of the last millisecond; `measured`: with a voltage that belongs
  /// to them.
  double before_a = 0.0;
  double after_a = 0.0;
  bool measured = false;
  /// What the winding lost as heat in this tick, W, also while it was not measured.
  double loss_w = 0.0;
  /// The thermistor that has the winding's temperature once the winding has rested.
  ThermistorReference reference;
};

/// Real-time safe, trivially copyable. Works out by itself when the winding has rested: what it was
/// heated by has gone into the core.
class WindingThermometer {
 public:
  WindingThermometer() noexcept : WindingThermometer(CoilModel{}, ThermalModel{}, 0) {}
  /// Winding `coil`, 0..2.
  WindingThermometer(const CoilModel& coils, const ThermalModel& thermal, int coil) noexcept;

  void set_accuracy(const CurrentAccuracy& accuracy) noexcept { meter_.set_accuracy(accuracy); }
  /// It starts as warm as its reference.
  void start_rested() noexcept { above_k_ = 0.0; }

  /// It is as warm as what surrounds it.
  bool rested() const noexcept { return above_k_ < kRestedK; }

  /// `dt_s` later, at most 20 ms.
  void step(const WindingReading& reading, double dt_s) noexcept;

  const WindingMeter& meter() const noexcept { return meter_; }
  /// Measured by V/I now.
  bool measuring() const noexcept { return meter_.valid(); }
  /// It rests, or has just begun to carry what its reference is made of.
  bool comparing() const noexcept { return comparing_; }
  /// The last step has completed a reference.
  bool reference_taken() const noexcept { return reference_taken_; }
  /// Compared with a reference of its own, not with the device file.
  bool referenced() const noexcept { return referenced_; }
  /// Its resistance at 25 C by its reference (else by the file), with this board's gains in it,
  /// ohm.
  double r25_ohm() const noexcept { return r25_ohm_; }
  /// The share by which an offset of the current of 1 A has lowered that.
  double reference_per_ampere() const noexcept { return reference_per_ampere_; }
  /// By V/I; before the first that at 25 C, ohm.
  double resistance_ohm() const noexcept {
    return meter_.resistance_ohm() > 0.0 ? meter_.resistance_ohm() : r25_ohm_;
  }
  /// By V/I; the last one while not measuring, the file's 25 C before the first.
  double celsius() const noexcept;
  /// Three standard deviations of its noise, and what an offset of the current makes of it, K; only
  /// while measuring. The second takes into account that the reference has the same offset.
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
  // How far it is above its surroundings, and how much it has been warmed since it was at rest, K.
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

// SPDX-License-Identifier: MIT
// Resistance of a winding from bridge voltage and current.
#pragma once

#include "model/estimate/current_accuracy.h"

namespace hedgehog::model {

/// Least squares of V = R I + L dI/dt with exponential forgetting. The inductance is fitted too,
/// around its nominal value, so that a transient is not mistaken for heat when L is off by 20 %;
/// the noisier the currents, the closer to nominal. Currents are weighted by their square.
/// Real-time safe, trivially copyable.
class WindingMeter {
 public:
  /// V/I is not used below this current: the relative error by offset and noise is too large.
  static constexpr double kMinCurrentA = 1.5;
  /// Time constant of the forgetting.
  static constexpr double kMemoryS = 0.05;

  constexpr WindingMeter() noexcept = default;
  explicit WindingMeter(double inductance_h) noexcept : nominal_h_(inductance_h) {}

  /// Accuracy of the currents; exact until set.
  void set_accuracy(const CurrentAccuracy& accuracy) noexcept { accuracy_ = accuracy; }

  /// Advances by `dt_s` (at most 20 ms) with the measurements of its last millisecond, which
  /// represents all of it: mean bridge voltage, and currents at its start and end. With `measured`
  /// false the earlier ones only lose weight.
  void step(double voltage_v, double before_a, double after_a, bool measured, double dt_s) noexcept;

  /// True while enough current has flowed recently: about 5 ms at 5 A, 45 ms at 1.5 A, or a pulse
  /// train above 5 A with 8 % duty.
  bool valid() const noexcept { return valid_; }
  /// The resistance, ohm; the last valid one while not valid, 0 before the first.
  double resistance_ohm() const noexcept { return resistance_ohm_; }
  /// Relative error of the resistance by current noise and, while currents change, by an unsigned
  /// sensor; only while valid.
  double noise() const noexcept;
  /// Relative decrease of the resistance per ampere of current offset; only while valid. 0 in a
  /// vibration, whose half periods cancel.
  double per_ampere() const noexcept { return ii_ > 0.0 ? offset_ / ii_ : 0.0; }
  double offset_a() const noexcept { return accuracy_.offset_a; }
  /// RMS of the recently measured current, A.
  double current_a() const noexcept;

 private:
  /// Ratio of the recent inductive voltage to the resistive voltage.
  double agitation() const noexcept;

  double nominal_h_ = 1.5e-3;
  CurrentAccuracy accuracy_;
  double ii_ = 0.0;
  double offset_ = 0.0;  // increase of ii per ampere of offset
  double id_ = 0.0;
  double dd_ = 0.0;
  double vi_ = 0.0;
  double vd_ = 0.0;
  double driven_s_ = 0.0;
  double measured_s_ = 0.0;
  double weights_ = 0.0;  // sum of squared weights of the readings
  double resistance_ohm_ = 0.0;
  bool valid_ = false;
};

}  // namespace hedgehog::model

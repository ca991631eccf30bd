// SPDX-License-Identifier: MIT
// Resistance of a winding from bridge voltage and current.
#pragma once

#include "model/estimate/current_accuracy.h"

namespace hedgehog::model {

/// Least squares of V = R I + L dI/dt with exponential forgetting, weighted by the square of the
/// current. L is fitted too, the closer to nominal the noisier the currents, so that a transient is
/// not mistaken for heat when L is off by 20 %. Real-time safe, trivially copyable.
class WindingMeter {
 public:
  static constexpr double kMinCurrentA = 1.5;  // below, offset and noise are too large for V/I
  static constexpr double kMemoryS = 0.05;     // time constant of the forgetting

  constexpr WindingMeter() noexcept = default;
  explicit WindingMeter(double inductance_h) noexcept : nominal_h_(inductance_h) {}

  /// Until set, the currents are exact.
  void set_accuracy(const CurrentAccuracy& accuracy) noexcept { accuracy_ = accuracy; }

  /// Advances by `dt_s` (at most 20 ms) with mean bridge voltage, and currents at start and end, of
  /// its last millisecond, which represents all of it. Not `measured`: earlier ones lose weight.
  void step(double voltage_v, double before_a, double after_a, bool measured, double dt_s) noexcept;

  /// Enough recent current: about 5 ms at 5 A, 45 ms at 1.5 A, or pulses above 5 A with 8 % duty.
  bool valid() const noexcept { return valid_; }
  /// The last valid one while not valid, 0 before the first.
  double resistance_ohm() const noexcept { return resistance_ohm_; }
  /// Relative error by current noise and, while currents change, an unsigned sensor; while valid.
  double noise() const noexcept;
  /// Relative decrease of the resistance per ampere of current offset; only while valid. 0 in a
  /// vibration, whose half periods cancel.
  double per_ampere() const noexcept { return ii_ > 0.0 ? offset_ / ii_ : 0.0; }
  double offset_a() const noexcept { return accuracy_.offset_a; }
  double current_a() const noexcept;  // RMS of the recently measured current

 private:
  double agitation() const noexcept;  // recent inductive voltage relative to the resistive voltage

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

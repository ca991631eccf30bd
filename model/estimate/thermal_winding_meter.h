// SPDX-License-Identifier: MIT
// A winding as its own thermometer: its resistance from bridge voltage and current.
#pragma once

#include "model/estimate/current_accuracy.h"

namespace hedgehog::model {

/// Exponentially forgotten least squares of V = R I + L dI/dt. The inductance is fitted too,
/// around its nominal value, so that a transient does not pass for heat when L is off by 20 %: the
/// more firmly nominal, the noisier the currents are, since their noise looks like change.
/// Heavy currents weigh by their square. Real-time safe, trivially copyable.
class WindingMeter {
 public:
  /// Below this current V/I is not used: offset and noise of the measurements are too large a
  /// share.
  static constexpr double kMinCurrentA = 1.5;
  /// How long a tick is remembered.
  static constexpr double kMemoryS = 0.05;

  constexpr WindingMeter() noexcept = default;
  explicit WindingMeter(double inductance_h) noexcept : nominal_h_(inductance_h) {}

  /// How well its currents are known; 0 until then.
  void set_accuracy(const CurrentAccuracy& accuracy) noexcept { accuracy_ = accuracy; }

  /// `dt_s` later (at most 20 ms), of which the last millisecond was measured and stands for all:
  /// its mean bridge voltage and the currents at its start and end. A step that was not measured
  /// (`measured` false) only forgets.
  void step(double voltage_v, double before_a, double after_a, bool measured, double dt_s) noexcept;

  /// True while enough current has flowed lately: about 5 ms at 5 A, 45 ms at 1.5 A, and in
  /// a pulse train above 5 A with 8 % on.
  bool valid() const noexcept { return valid_; }
  /// The resistance, ohm; the last valid one while not valid, 0 before the first.
  double resistance_ohm() const noexcept { return resistance_ohm_; }
  /// What the noise of the currents makes of it and, while they change, what a sensor without sign
  /// misses; and the most that their offset can. As shares of it; only while valid.
  double noise() const noexcept;
  double bias() const noexcept;
  /// By which share an offset of the current of 1 A lowers it; only while valid. None in
  /// a vibration, whose halves cancel.
  double per_ampere() const noexcept { return ii_ > 0.0 ? offset_ / ii_ : 0.0; }
  double offset_a() const noexcept { return accuracy_.offset_a; }
  /// The rms current of what was measured lately, A.
  double current_a() const noexcept;

 private:
  /// How much of the voltage of lately went into changes of the current, against what the
  /// resistance took.
  double agitation() const noexcept;

  double nominal_h_ = 1.5e-3;
  CurrentAccuracy accuracy_;
  double ii_ = 0.0;
  double offset_ = 0.0;  // what an offset of 1 A adds to ii
  double id_ = 0.0;
  double dd_ = 0.0;
  double vi_ = 0.0;
  double vd_ = 0.0;
  double driven_s_ = 0.0;
  double measured_s_ = 0.0;
  double weights_ = 0.0;  // squares of what each reading counts
  double resistance_ohm_ = 0.0;
  bool valid_ = false;
};

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// Current and temperature limits of a ball. The device file contains the ceiling; configuration may
// only tighten it.
#pragma once

namespace hedgehog::model {

/// Currents are Euclidean norms over the three windings, ampere; temperatures degrees Celsius.
/// Trivially copyable.
struct Limits {
  /// Maximum current (thesis section 3.1.1: 15 A for about 30 s). 0.5..15.
  double current_a = 15.0;
  /// Continuous current (thesis section 3.1.1: 5 A). 0.5..current_a.
  double continuous_a = 5.0;
  /// Perception threshold (thesis section 3.3, experiment 1).
  double felt_a = 2.1;
  /// Full current up to here; above, I^2 falls linearly to continuous_a^2 at `sustain_c`.
  double derate_from_c = 60.0;
  /// continuous_a here; above, the current falls to zero at `zero_c`.
  double sustain_c = 67.0;
  double zero_c = 69.0;
  /// The watchdog trips at this temperature held for 50 ms.
  double trip_c = 70.0;
  /// `device.arm` after a thermal trip needs a temperature below max(rearm_c, ambient estimate + 10
  /// K).
  double rearm_c = 45.0;
  friend constexpr bool operator==(const Limits&, const Limits&) noexcept = default;
};

/// True if no limit of `tightened` exceeds that of `ceiling`.
constexpr bool is_within(const Limits& tightened, const Limits& ceiling) noexcept {
  return tightened.current_a <= ceiling.current_a &&
         tightened.continuous_a <= ceiling.continuous_a &&
         tightened.derate_from_c <= ceiling.derate_from_c &&
         tightened.sustain_c <= ceiling.sustain_c && tightened.zero_c <= ceiling.zero_c &&
         tightened.trip_c <= ceiling.trip_c && tightened.rearm_c <= ceiling.rearm_c;
}

}  // namespace hedgehog::model

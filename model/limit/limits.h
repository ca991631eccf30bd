// SPDX-License-Identifier: MIT
// Current and temperature limits of a ball. The device file contains the ceiling; configuration may
// only tighten it.
#pragma once

namespace hedgehog::model {

/// Currents are Euclidean norms over the three windings. Trivially copyable.
struct Limits {
  double current_a = 15.0;      // 0.5..15 (thesis section 3.1.1: 15 A for about 30 s)
  double continuous_a = 5.0;    // 0.5..current_a (thesis section 3.1.1: 5 A)
  double felt_a = 2.1;          // perception threshold (thesis section 3.3, experiment 1)
  double derate_from_c = 60.0;  // full current; above, I^2 falls linearly to continuous_a^2
  double sustain_c = 67.0;      // continuous_a; above, the current falls linearly
  double zero_c = 69.0;         // no current
  double trip_c = 70.0;         // held for 50 ms, the watchdog trips
  double rearm_c = 45.0;        // for `device.arm` after a thermal trip (`rearm_below_c`)
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

// SPDX-License-Identifier: MIT
// When a winding's current is converted: in the middle of the on-time of its bridge's PWM, where
// the ripple passes through its mean. A PWM slice of the same period wraps earlier by the time from
// its interrupt to the end of the converter's sampling, less the delay of the converter's input.
#pragma once

#include <stdint.h>

namespace hedgehog::firmware {

/// Connected to no pin.
inline constexpr uint32_t kSamplingSlice = 2;

/// From the wrap to the end of the converter's sampling: the wake-up and the register accesses
/// (0.4 us), and 7.5 of its clocks of 832 ns (DS21298E, figure 6-1: the falling edge of the
/// seventh).
inline constexpr uint32_t kSampledAfterNs = 6'600;

/// Delay of the converter's input: the amplifier (400 kHz) and its filter (100 ohm, 10 nF).
inline constexpr uint32_t kInputDelayNs = 1'400;

/// REQUIRES: the slices are not enabled yet; they have to be enabled at once, from 0 on.
void prepare_sampling_points() noexcept;

/// One that has passed does not count.
void clear_sampling_point() noexcept;

/// Sleeps until the first sampling point since the last call of this or of `clear_sampling_point`:
/// at most a PWM period, not at all if it has passed. Other interrupts are not served meanwhile.
void wait_for_sampling_point() noexcept;

}  // namespace hedgehog::firmware

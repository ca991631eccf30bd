// SPDX-License-Identifier: MIT
// When a winding's current is converted: in the middle of the on-time of its bridge's PWM, where
// the ripple passes through its mean, as the converter's input sees it. A PWM slice of the same
// period wraps so much earlier that its sampling ends then.
#pragma once

#include <stdint.h>

namespace hedgehog::firmware {

/// Connected to no pin.
inline constexpr uint32_t kSamplingSlice = 2;

/// From the wrap to the end of the converter's sampling: the wake-up and the register accesses
/// (0.4 us), and 10.5 of its clocks of 832 ns (DS21298E, figure 6-1).
inline constexpr uint32_t kSampledAfterNs = 9'100;

/// By which the converter's input follows the current: the amplifier (400 kHz) and its filter
/// (100 ohm, 10 nF).
inline constexpr uint32_t kInputLagNs = 1'400;

/// REQUIRES: the slices are not enabled yet; they have to be enabled at once, from 0 on.
void prepare_sampling_points() noexcept;

/// Sleeps until the next sampling point, at most a PWM period. Other interrupts wait meanwhile.
void wait_for_sampling_point() noexcept;

}  // namespace hedgehog::firmware

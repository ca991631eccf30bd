// SPDX-License-Identifier: MIT
// The detector of a brown-out of the core's supply, which resets the chip (data sheet 2.10.6,
// 2.12.3).
#pragma once

#include "firmware/registers.h"

namespace hedgehog::firmware {

/// On, at 0.946 V (0.913 to 0.979 V), the highest step below the 0.99 V from which the core is
/// specified (5.3). In reset it is 0.86 V.
inline void start_brown_out_detector() noexcept {
  reg(kVregAndChipReset + 0x04) = (11u << 4) | (1u << 0);
}

}  // namespace hedgehog::firmware

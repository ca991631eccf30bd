// SPDX-License-Identifier: MIT
// The flash chip's own number, which makes one Pico differ from another.
#pragma once

#include <stdint.h>

namespace hedgehog::firmware {

inline constexpr uint32_t kSerialDigits = 16;

/// 16 hexadecimal digits and a 0; "NO-FLASH-ID" when the chip has none. Ends the reading of the
/// flash at 0x10000000: nothing of this firmware is there any more.
void read_serial(char (&serial)[kSerialDigits + 1]) noexcept;

}  // namespace hedgehog::firmware

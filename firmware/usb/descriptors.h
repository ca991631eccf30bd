// SPDX-License-Identifier: MIT
// What the board says of itself on USB: daemon/device/board-protocol.md, and the Microsoft OS 2.0
// descriptors with which Windows takes WinUSB without a driver file.
#pragma once

#include <stdint.h>

namespace hedgehog::firmware {

struct Descriptor {
  const uint8_t* bytes = nullptr;
  uint16_t length = 0;
};

/// bRequest of the vendor's request for the Microsoft OS 2.0 descriptors.
inline constexpr uint8_t kMicrosoftRequest = 0x48;

/// Of `type` and `index` as in wValue; null bytes: there is none.
Descriptor descriptor(uint8_t type, uint8_t index) noexcept;
Descriptor microsoft_descriptors() noexcept;

/// At most 31 ASCII characters, before the first descriptor is asked for.
void set_serial(const char* text) noexcept;

}  // namespace hedgehog::firmware

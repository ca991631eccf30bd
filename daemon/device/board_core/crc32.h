// SPDX-License-Identifier: MIT
// CRC-32 of IEEE 802.3 (polynomial 0x04C11DB7 reflected, start and final xor 0xFFFFFFFF; the nine
// ASCII digits "123456789" give 0xCBF43926). Over 60 bytes it detects every burst of up to 32 bits.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace hedgehog::board {

uint32_t crc32(const uint8_t* bytes, size_t length) noexcept;  // any thread

}  // namespace hedgehog::board

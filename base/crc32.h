// SPDX-License-Identifier: MIT
// The CRC-32 of IEEE 802.3, zlib and PNG. The board core has its own, which needs no library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hedgehog::base {

/// 0xCBF43926 of "123456789"; 0 of nothing. Any thread.
std::uint32_t crc32(std::span<const std::byte> bytes) noexcept;

}  // namespace hedgehog::base

// SPDX-License-Identifier: MIT
// CRC-32 of IEEE 802.3, zlib and PNG. The board core has its own implementation without a library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hedgehog::base {

/// 0xCBF43926 for "123456789"; 0 for no bytes. Any thread.
std::uint32_t crc32(std::span<const std::byte> bytes) noexcept;

}  // namespace hedgehog::base

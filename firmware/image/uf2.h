// SPDX-License-Identifier: MIT
// What a boot ROM of an RP2040 wants: the check sum of the second stage, and UF2 files for its mass
// storage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hedgehog::firmware {

/// The second stage with its check sum.
inline constexpr std::size_t kBoot2Size = 256;

/// CRC-32/MPEG-2: polynomial 0x04C11DB7, start 0xFFFFFFFF, nothing reflected, no final xor (RP2040
/// data sheet 2.8.1.3.1).
std::uint32_t crc32_mpeg2(std::span<const std::uint8_t> bytes) noexcept;

/// `code` filled up with zeros to 252 bytes, and its check sum. nullopt: it is longer.
std::optional<std::vector<std::uint8_t>> boot2_with_crc(std::span<const std::uint8_t> code);

/// `image` for the flash at `address` in blocks of 256 bytes (github.com/microsoft/uf2).
std::vector<std::uint8_t> uf2(std::span<const std::uint8_t> image, std::uint32_t address);

}  // namespace hedgehog::firmware

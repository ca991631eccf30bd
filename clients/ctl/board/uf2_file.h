// SPDX-License-Identifier: MIT
// A UF2 file for the boot loader of an RP2040, validated before the board is touched: the boot
// loader itself silently ignores invalid blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "clients/lib/client_error.h"

namespace hedgehog::client {

/// The flash of the reference board in its processor's address space.
inline constexpr std::uint32_t kFlashBegin = 0x10000000;
inline constexpr std::uint32_t kFlashBytes = 2 * 1024 * 1024;
/// Size of a block of the file, and of its payload.
inline constexpr std::size_t kUf2BlockBytes = 512;
inline constexpr std::uint32_t kUf2PayloadBytes = 256;

/// Summary of a valid file.
struct Uf2Image {
  std::uint32_t blocks = 0;
  /// One past the last address that is written.
  std::uint32_t end = kFlashBegin;

  std::uint32_t bytes() const noexcept { return blocks * kUf2PayloadBytes; }
  friend bool operator==(const Uf2Image&, const Uf2Image&) = default;
};

/// Accepts any bytes. kBadData: a sentence without the file's name, "block 3 is for 0x20000000,
/// ...". A valid file writes each of its pages once, inside the flash, including the first page.
/// Format: github.com/microsoft/uf2; RP2040 data sheet 2.8.4.2.
Outcome<Uf2Image> read_uf2(std::span<const std::uint8_t> file);

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// A UF2 file for the boot loader of an RP2040, checked before the board is asked for anything: the
// boot loader itself silently ignores what it does not like.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "clients/lib/client_error.h"

namespace hedgehog::client {

/// The flash of the reference board as its processor addresses it.
inline constexpr std::uint32_t kFlashBegin = 0x10000000;
inline constexpr std::uint32_t kFlashBytes = 2 * 1024 * 1024;
/// A block of the file, and what it brings into the flash.
inline constexpr std::size_t kUf2BlockBytes = 512;
inline constexpr std::uint32_t kUf2PayloadBytes = 256;

/// What a whole file brings.
struct Uf2Image {
  std::uint32_t blocks = 0;
  /// The last address that is written, and one.
  std::uint32_t end = kFlashBegin;

  std::uint32_t bytes() const noexcept { return blocks * kUf2PayloadBytes; }
  friend bool operator==(const Uf2Image&, const Uf2Image&) = default;
};

/// Any bytes. kBadData, behind the file's name a sentence: "block 3 is for 0x20000000, ...". A file
/// that is taken writes each of its pages once, inside the flash, the first page among them.
/// Format: github.com/microsoft/uf2; RP2040 data sheet 2.8.4.2.
Outcome<Uf2Image> read_uf2(std::span<const std::uint8_t> file);

}  // namespace hedgehog::client

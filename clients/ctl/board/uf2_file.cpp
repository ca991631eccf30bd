// SPDX-License-Identifier: MIT
#include "clients/ctl/board/uf2_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <string>

namespace hedgehog::client {

namespace {

constexpr std::uint32_t kMagicFirst = 0x0A324655;
constexpr std::uint32_t kMagicSecond = 0x9E5D5157;
constexpr std::uint32_t kMagicLast = 0x0AB16F30;
constexpr std::uint32_t kNotForFlash = 0x00000001;
constexpr std::uint32_t kFamilyPresent = 0x00002000;
constexpr std::uint32_t kRp2040 = 0xE48BFF56;
constexpr std::uint32_t kPages = kFlashBytes / kUf2PayloadBytes;

using Block = std::span<const std::uint8_t, kUf2BlockBytes>;

std::uint32_t word(Block block, std::size_t at) noexcept {
  return std::uint32_t{block[at]} | std::uint32_t{block[at + 1]} << 8 |
         std::uint32_t{block[at + 2]} << 16 | std::uint32_t{block[at + 3]} << 24;
}

/// Why it is not the block `number` of `count`; empty: valid.
std::string check_head(Block block, std::uint32_t number, std::uint32_t count) {
  if (word(block, 0) != kMagicFirst || word(block, 4) != kMagicSecond ||
      word(block, kUf2BlockBytes - 4) != kMagicLast)
    return "is not a UF2 block: wrong magic numbers";
  const std::uint32_t flags = word(block, 8);
  if ((flags & kFamilyPresent) == 0) return "does not name the chip that it is for";
  if (const std::uint32_t family = word(block, 28); family != kRp2040) {
    return fmt::format("is for another chip, family 0x{:08X}; the board's RP2040 is 0x{:08X}",
                       family, kRp2040);
  }
  if ((flags & kNotForFlash) != 0) return "is not for the flash";
  if (const std::uint32_t bytes = word(block, 16); bytes != kUf2PayloadBytes)
    return fmt::format("has a payload of {} bytes instead of {}", bytes, kUf2PayloadBytes);
  if (const std::uint32_t counted = word(block, 24); counted != count)
    return fmt::format("counts {} blocks, and the file has {}", counted, count);
  if (const std::uint32_t given = word(block, 20); given != number)
    return fmt::format("has the number {}", given);
  return {};
}

/// Why `address` cannot be written; empty: valid.
std::string check_address(std::uint32_t address) {
  if (address < kFlashBegin || address - kFlashBegin >= kFlashBytes) {
    return fmt::format("is for 0x{:08X}, outside the flash (0x{:08X} to 0x{:08X})", address,
                       kFlashBegin, kFlashBegin + kFlashBytes - 1);
  }
  if (address % kUf2PayloadBytes != 0)
    return fmt::format("is for 0x{:08X}, which is no multiple of {}", address, kUf2PayloadBytes);
  return {};
}

}  // namespace

Outcome<Uf2Image> read_uf2(std::span<const std::uint8_t> file) {
  const auto bad = [](std::string why) {
    return ClientError{Failure::kBadData, std::move(why), {}};
  };
  if (file.empty()) return bad("is empty");
  if (file.size() % kUf2BlockBytes != 0) {
    return bad(
        fmt::format("has {} bytes; a UF2 file has blocks of {}", file.size(), kUf2BlockBytes));
  }
  if (file.size() / kUf2BlockBytes > kPages) {
    return bad(fmt::format("has {} blocks, more than the {} of the flash",
                           file.size() / kUf2BlockBytes, kPages));
  }
  Uf2Image image;
  image.blocks = static_cast<std::uint32_t>(file.size() / kUf2BlockBytes);
  std::bitset<kPages> written;
  for (std::uint32_t number = 0; number < image.blocks; ++number) {
    const Block block(file.subspan(number * kUf2BlockBytes).first<kUf2BlockBytes>());
    const std::uint32_t address = word(block, 12);
    std::string why = check_head(block, number, image.blocks);
    if (why.empty()) why = check_address(address);
    const std::uint32_t page = why.empty() ? (address - kFlashBegin) / kUf2PayloadBytes : 0;
    if (why.empty() && written[page])
      why = fmt::format("is for 0x{:08X}, as an earlier one is", address);
    if (!why.empty()) return bad(fmt::format("block {} {}", number, why));
    written.set(page);
    image.end = std::max(image.end, address + kUf2PayloadBytes);
  }
  // The chip starts with the second stage, in the first page.
  if (!written[0])
    return bad(fmt::format("has nothing for 0x{:08X}, where the chip starts", kFlashBegin));
  return image;
}

}  // namespace hedgehog::client

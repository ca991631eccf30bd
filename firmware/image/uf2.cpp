// SPDX-License-Identifier: MIT
#include "firmware/image/uf2.h"

#include <algorithm>

namespace hedgehog::firmware {
namespace {

constexpr std::size_t kPayload = 256;
constexpr std::size_t kBlock = 512;
constexpr std::size_t kDataAt = 32;

constexpr std::uint32_t kMagicFirst = 0x0A324655;
constexpr std::uint32_t kMagicSecond = 0x9E5D5157;
constexpr std::uint32_t kMagicLast = 0x0AB16F30;
constexpr std::uint32_t kFamilyPresent = 0x00002000;
constexpr std::uint32_t kRp2040 = 0xE48BFF56;

void put(std::span<std::uint8_t> at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(value >> 8 * i);
}

}  // namespace

std::uint32_t crc32_mpeg2(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= std::uint32_t{byte} << 24;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ ((crc >> 31) != 0 ? 0x04C11DB7u : 0u);
  }
  return crc;
}

std::optional<std::vector<std::uint8_t>> boot2_with_crc(std::span<const std::uint8_t> code) {
  if (code.size() > kBoot2Size - 4) return std::nullopt;
  std::vector<std::uint8_t> boot2(kBoot2Size, 0);
  std::copy(code.begin(), code.end(), boot2.begin());
  const auto bytes = std::span(boot2);
  put(bytes.last(4), crc32_mpeg2(bytes.first(kBoot2Size - 4)));
  return boot2;
}

std::vector<std::uint8_t> uf2(std::span<const std::uint8_t> image, std::uint32_t address) {
  const std::size_t count = (image.size() + kPayload - 1) / kPayload;
  std::vector<std::uint8_t> file(count * kBlock, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto block = std::span(file).subspan(i * kBlock, kBlock);
    const auto part = image.subspan(i * kPayload, std::min(kPayload, image.size() - i * kPayload));
    const std::uint32_t words[] = {kMagicFirst,
                                   kMagicSecond,
                                   kFamilyPresent,
                                   address + static_cast<std::uint32_t>(i * kPayload),
                                   static_cast<std::uint32_t>(kPayload),
                                   static_cast<std::uint32_t>(i),
                                   static_cast<std::uint32_t>(count),
                                   kRp2040};
    for (std::size_t word = 0; word < std::size(words); ++word)
      put(block.subspan(4 * word, 4), words[word]);
    std::copy(part.begin(), part.end(), block.begin() + kDataAt);
    put(block.last(4), kMagicLast);
  }
  return file;
}

}  // namespace hedgehog::firmware

// SPDX-License-Identifier: MIT
// Generated UF2 files, valid and slightly invalid ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hedgehog::client {

/// The index of a word in its block.
enum class Uf2Word : std::size_t {
  kMagicFirst = 0,
  kMagicSecond = 4,
  kFlags = 8,
  kAddress = 12,
  kBytes = 16,
  kNumber = 20,
  kCount = 24,
  kFamily = 28,
  kMagicLast = 508,
};

class Uf2Sample {
 public:
  /// One page for each address, in this order.
  explicit Uf2Sample(const std::vector<std::uint32_t>& addresses) : file_(512 * addresses.size()) {
    for (std::size_t i = 0; i < addresses.size(); ++i) {
      put(i, Uf2Word::kMagicFirst, 0x0A324655);
      put(i, Uf2Word::kMagicSecond, 0x9E5D5157);
      put(i, Uf2Word::kFlags, 0x00002000);
      put(i, Uf2Word::kAddress, addresses[i]);
      put(i, Uf2Word::kBytes, 256);
      put(i, Uf2Word::kNumber, static_cast<std::uint32_t>(i));
      put(i, Uf2Word::kCount, static_cast<std::uint32_t>(addresses.size()));
      put(i, Uf2Word::kFamily, 0xE48BFF56);
      put(i, Uf2Word::kMagicLast, 0x0AB16F30);
      for (std::size_t k = 0; k < 256; ++k)
        file_[512 * i + 32 + k] = static_cast<std::uint8_t>(i + k);
    }
  }
  /// `count` pages from the beginning of the flash.
  static Uf2Sample pages(std::uint32_t count) {
    std::vector<std::uint32_t> addresses;
    for (std::uint32_t i = 0; i < count; ++i) addresses.push_back(0x10000000 + 256 * i);
    return Uf2Sample(addresses);
  }

  Uf2Sample& put(std::size_t block, Uf2Word word, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i)
      file_[512 * block + static_cast<std::size_t>(word) + i] =
          static_cast<std::uint8_t>(value >> 8 * i);
    return *this;
  }
  const std::vector<std::uint8_t>& file() const noexcept { return file_; }
  std::string text() const { return {file_.begin(), file_.end()}; }

 private:
  std::vector<std::uint8_t> file_;
};

}  // namespace hedgehog::client

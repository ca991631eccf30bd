// SPDX-License-Identifier: MIT
#include "daemon/device/board_core/crc32.h"

namespace hedgehog::board {
namespace {

// A nibble at a time: 64 bytes of table instead of the usual 1 KiB, for small firmware.
struct NibbleTable {
  uint32_t entry[16] = {};
  constexpr NibbleTable() noexcept {
    for (uint32_t nibble = 0; nibble < 16; ++nibble) {
      uint32_t remainder = nibble;
      for (int bit = 0; bit < 4; ++bit)
        remainder = (remainder >> 1) ^ ((remainder & 1u) != 0 ? 0xEDB88320u : 0u);
      entry[nibble] = remainder;
    }
  }
};

constexpr NibbleTable kTable;

}  // namespace

uint32_t crc32(const uint8_t* bytes, size_t length) noexcept {
  uint32_t crc = 0xFFFFFFFFu;
  for (size_t i = 0; i < length; ++i) {
    crc ^= bytes[i];
    crc = (crc >> 4) ^ kTable.entry[crc & 15u];
    crc = (crc >> 4) ^ kTable.entry[crc & 15u];
  }
  return ~crc;
}

}  // namespace hedgehog::board

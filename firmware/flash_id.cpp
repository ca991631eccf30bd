// SPDX-License-Identifier: MIT
#include "firmware/flash_id.h"

#include "firmware/registers.h"

namespace hedgehog::firmware {
namespace {

// W25Q16JV data sheet, 8.2.19: 4Bh, four bytes of nothing, eight of the number.
constexpr uint32_t kReadUniqueId = 0x4B;
constexpr uint32_t kHeader = 5;
constexpr uint32_t kIdBytes = 8;

// 4.10.13
constexpr uint32_t kData = kSsi + 0x60;
constexpr uint32_t kStatus = kSsi + 0x28;
constexpr uint32_t kReceived = 1u << 3;

/// 2.19.6.2: the chip select as a plain output, or of SSI again.
enum class ChipSelect : uint32_t { kAuto = 0, kLow = 2, kHigh = 3 };
void select(ChipSelect level) noexcept { reg(kIoQspi + 0x0C) = static_cast<uint32_t>(level) << 8; }

uint8_t exchange(uint32_t byte) noexcept {
  reg(kData) = byte;
  while ((reg(kStatus) & kReceived) == 0) {
  }
  return static_cast<uint8_t>(reg(kData));
}

}  // namespace

void read_serial(char (&serial)[kSerialDigits + 1]) noexcept {
  reg(kSsi + 0x08) = 0;
  reg(kSsi + 0x00) = 7u << 16;  // 8 bits, both ways at once
  reg(kSsi + 0x14) = 8;         // clk_sys / 8
  reg(kSsi + 0x10) = 1;
  reg(kSsi + 0x08) = 1;
  select(ChipSelect::kLow);
  for (uint32_t i = 0; i < kHeader; ++i) exchange(i == 0 ? kReadUniqueId : 0);
  uint8_t any = 0;
  uint8_t all = 0xFF;
  for (uint32_t i = 0; i < kIdBytes; ++i) {
    const uint8_t byte = exchange(0);
    any = static_cast<uint8_t>(any | byte);
    all = static_cast<uint8_t>(all & byte);
    constexpr const char* kDigits = "0123456789ABCDEF";
    serial[2 * i] = kDigits[byte >> 4];
    serial[2 * i + 1] = kDigits[byte & 15];
  }
  select(ChipSelect::kHigh);
  serial[kSerialDigits] = 0;
  if (any != 0 && all != 0xFF) return;
  constexpr char kNone[] = "NO-FLASH-ID";
  for (uint32_t i = 0; i < sizeof(kNone); ++i) serial[i] = kNone[i];
}

}  // namespace hedgehog::firmware

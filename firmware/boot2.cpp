// SPDX-License-Identifier: MIT
// The second stage of the boot (data sheet 2.8.1.3): the boot ROM copies these 252 bytes to the end
// of SRAM, compares their CRC and jumps there. It makes the flash readable at 0x10000000 with the
// plain 03h read that every flash chip knows, and enters the image behind it.
#include "firmware/registers.h"

namespace hedgehog::firmware {

extern "C" [[noreturn, gnu::section(".boot2"), gnu::used]] void second_stage() {
  // 4.10.13: SSI off; clk_sys / 4; 32 bits a transfer, read by EEPROM mode; command 03h of 8 bits,
  // address of 24 bits; on.
  reg(kSsi + 0x08) = 0;
  reg(kSsi + 0x14) = 4;
  reg(kSsi + 0x00) = (31u << 16) | (3u << 8);
  reg(kSsi + 0x04) = 0;
  reg(kSsi + 0xF4) = (0x03u << 24) | (2u << 8) | (6u << 2);
  reg(kSsi + 0x08) = 1;
  constexpr uint32_t kImage = 0x10000100;
  reg(kVectorTable) = kImage;
  asm volatile("msr msp, %0\n\tbx %1" : : "l"(reg(kImage)), "l"(reg(kImage + 4)));
  __builtin_unreachable();
}

}  // namespace hedgehog::firmware

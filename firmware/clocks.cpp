// SPDX-License-Identifier: MIT
#include "firmware/clocks.h"

#include "firmware/registers.h"

namespace hedgehog::firmware {
namespace {

// 2.14.3: bits of RESETS.
constexpr uint32_t kPllResets = (1u << 12) | (1u << 13);
constexpr uint32_t kUsbReset = 1u << 24;
// Pins, their pads, PWM, SPI0, SYSINFO, timer, USB.
constexpr uint32_t kPeripheralResets =
    (1u << 5) | (1u << 8) | (1u << 14) | (1u << 16) | (1u << 19) | (1u << 21) | kUsbReset;

void restart(uint32_t blocks) noexcept {
  set_bits(kResets, blocks);
  clear_bits(kResets, blocks);
  while ((~reg(kResets + 8) & blocks) != 0) {
  }
}

/// 2.18.2.1: the order of the steps.
void start_pll(uint32_t base, uint32_t multiplier, uint32_t divider1, uint32_t divider2) noexcept {
  reg(base + 0x0) = 1;
  reg(base + 0x8) = multiplier;
  clear_bits(base + 0x4, (1u << 0) | (1u << 5));
  while ((reg(base + 0x0) >> 31) == 0) {
  }
  reg(base + 0xC) = (divider1 << 16) | (divider2 << 12);
  clear_bits(base + 0x4, 1u << 3);
}

}  // namespace

void start_clocks() noexcept {
  // 2.16.3, 2.16.7: 1..15 MHz; 47 x 256 cycles of 12 MHz are the millisecond that a crystal takes.
  reg(kXosc + 0xC) = 47;
  reg(kXosc + 0x0) = 0xFABAA0;
  while ((reg(kXosc + 0x4) >> 31) == 0) {
  }
  // 2.15.7: clk_sys from clk_ref, that from the crystal, until the PLLs run.
  reg(kClocks + 0x3C) = 0;
  while (reg(kClocks + 0x44) != 1) {
  }
  reg(kClocks + 0x30) = 2;
  while (reg(kClocks + 0x38) != 4) {
  }
  restart(kPllResets);
  start_pll(kPllSys, 125, 6, 2);  // 12 MHz x 125 / 12
  start_pll(kPllUsb, 100, 5, 5);  // 12 MHz x 100 / 25
  reg(kClocks + 0x3C) = 1;
  while (reg(kClocks + 0x44) != 2) {
  }
  reg(kClocks + 0x48) = 1u << 11;  // clk_peri = clk_sys
  reg(kClocks + 0x54) = 1u << 11;  // clk_usb = PLL_USB
  // 4.7.2: 12 MHz / 12.
  reg(kWatchdog + 0x2C) = 12u | (1u << 9);
}

void start_peripherals() noexcept { restart(kPeripheralResets); }

void restart_usb() noexcept { restart(kUsbReset); }

}  // namespace hedgehog::firmware

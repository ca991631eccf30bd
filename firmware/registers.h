// SPDX-License-Identifier: MIT
// The registers of an RP2040 by their addresses. Sections are those of the RP2040 data sheet.
#pragma once

#include <stdint.h>

namespace hedgehog::firmware {

// 2.2.1, 2.2.2: address map.
inline constexpr uint32_t kRom = 0x00000000;
inline constexpr uint32_t kSsi = 0x18000000;
inline constexpr uint32_t kSysInfo = 0x40000000;
inline constexpr uint32_t kClocks = 0x40008000;
inline constexpr uint32_t kResets = 0x4000C000;
inline constexpr uint32_t kPsm = 0x40010000;
inline constexpr uint32_t kIoBank0 = 0x40014000;
inline constexpr uint32_t kIoQspi = 0x40018000;
inline constexpr uint32_t kPadsBank0 = 0x4001C000;
inline constexpr uint32_t kXosc = 0x40024000;
inline constexpr uint32_t kPllSys = 0x40028000;
inline constexpr uint32_t kPllUsb = 0x4002C000;
inline constexpr uint32_t kSpi0 = 0x4003C000;
inline constexpr uint32_t kPwm = 0x40050000;
inline constexpr uint32_t kTimer = 0x40054000;
inline constexpr uint32_t kWatchdog = 0x40058000;
inline constexpr uint32_t kVregAndChipReset = 0x40064000;
inline constexpr uint32_t kUsbMemory = 0x50100000;
inline constexpr uint32_t kUsb = 0x50110000;
inline constexpr uint32_t kSio = 0xD0000000;
inline constexpr uint32_t kNvicEnable = 0xE000E100;
inline constexpr uint32_t kNvicDisable = 0xE000E180;
inline constexpr uint32_t kNvicClearPending = 0xE000E280;
inline constexpr uint32_t kVectorTable = 0xE000ED08;

// 2.3.2: interrupt numbers.
inline constexpr uint32_t kTimerInterrupt = 1u << 0;
inline constexpr uint32_t kPwmInterrupt = 1u << 4;
inline constexpr uint32_t kUsbInterrupt = 1u << 5;
inline constexpr uint32_t kPinInterrupt = 1u << 13;

// 4.5.3: the slices of the PWM.
constexpr uint32_t pwm_slice(uint32_t number) noexcept { return kPwm + 0x14 * number; }
inline constexpr uint32_t kPwmControl = 0x00;
inline constexpr uint32_t kPwmCounter = 0x08;
inline constexpr uint32_t kPwmCompare = 0x0C;
inline constexpr uint32_t kPwmWrapValue = 0x10;
inline constexpr uint32_t kPwmEnabled = kPwm + 0xA0;
inline constexpr uint32_t kPwmWraps = kPwm + 0xA4;
inline constexpr uint32_t kPwmWrapInterrupts = kPwm + 0xA8;

inline volatile uint32_t& reg(uint32_t address) noexcept {
  return *reinterpret_cast<volatile uint32_t*>(address);
}

/// 2.1.2: the aliases that set and clear bits at once. Not for SIO and the USB memory.
inline void set_bits(uint32_t address, uint32_t bits) noexcept { reg(address + 0x2000) = bits; }
inline void clear_bits(uint32_t address, uint32_t bits) noexcept { reg(address + 0x3000) = bits; }

/// 4.6.4: microseconds since reset, modulo 2^32.
inline uint32_t now_us() noexcept { return reg(kTimer + 0x28); }

}  // namespace hedgehog::firmware

// SPDX-License-Identifier: MIT
// The pins of the Raspberry Pi Pico on the reference board (table: README.md).
#pragma once

#include <stdint.h>

#include "daemon/device/board_core/port.h"

namespace hedgehog::firmware {

inline constexpr uint32_t kPwmPin = 0;  // 0, 1, 2: PWM slices 0A, 0B, 1A
inline constexpr uint32_t kDirPin = 3;  // 3, 4, 5
inline constexpr uint32_t kSleepPin = 6;
inline constexpr uint32_t kFaultPin = 7;  // 7, 8, 9
inline constexpr uint32_t kFanPin = 10;   // PWM slice 5A
inline constexpr uint32_t kTachPin = 11;
inline constexpr uint32_t kSupplySwitchPin = 12;
inline constexpr uint32_t kSpiInPin = 16;
inline constexpr uint32_t kSpiSelectPin = 17;
inline constexpr uint32_t kSpiClockPin = 18;
inline constexpr uint32_t kSpiOutPin = 19;
inline constexpr uint32_t kVbusPin = 24;
inline constexpr uint32_t kLedPin = 25;

/// All outputs at their safe level, then driven. REQUIRES: the peripherals are out of reset.
void start_pins() noexcept;

/// Outputs until the next call. A bridge turns round at the end of a PWM period, with the new
/// compare value: waits for it, at most `kMaxTurnUs`, when one of them has to.
void set_pins(const board::PinOutputs& pins) noexcept;
inline constexpr uint32_t kMaxTurnUs = 60;

/// Bridges asleep and braked, fan full. At any time after `start_pins`, and from a fault handler:
/// it uses nothing but registers.
void set_safe_pins() noexcept;

/// Bit k: FLT of driver k is low.
uint8_t faults_low() noexcept;

/// SLP as it is driven.
bool bridges_awake() noexcept;

/// The host's cable is in.
bool vbus_present() noexcept;

}  // namespace hedgehog::firmware

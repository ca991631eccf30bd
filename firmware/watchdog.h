// SPDX-License-Identifier: MIT
// The hardware watchdog (data sheet 4.7): a main loop that hangs is a reset, and in reset the pins
// are safe by their resistors.
#pragma once

#include "firmware/registers.h"

namespace hedgehog::firmware {

inline constexpr uint32_t kWatchdogMs = 20;

inline void feed_watchdog() noexcept {
  // Erratum RP2040-E1: it counts down twice a microsecond.
  reg(kWatchdog + 0x04) = 2u * 1000u * kWatchdogMs;
}

inline void start_watchdog() noexcept {
  // 2.13.5: everything but the oscillators is reset.
  reg(kPsm + 0x08) = 0x1FFFC;
  feed_watchdog();
  reg(kWatchdog + 0x00) = 1u << 30;
}

}  // namespace hedgehog::firmware

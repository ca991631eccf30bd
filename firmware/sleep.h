// SPDX-License-Identifier: MIT
// Sleep until an interrupt is pending. Interrupts stay masked: one that is pending ends the sleep
// and enters no handler (ARMv6-M Architecture Reference Manual, WFI).
#pragma once

#include <stdint.h>

#include "firmware/registers.h"

namespace hedgehog::firmware {

/// The interrupts that end a sleep, for its lifetime; at most one exists. `clear`, check the
/// condition, then `sleep`: an interrupt in between stays pending and ends the sleep.
class Wakeups {
 public:
  explicit Wakeups(uint32_t interrupts) noexcept : interrupts_(interrupts) {
    reg(kNvicEnable) = interrupts_;
  }
  ~Wakeups() { reg(kNvicDisable) = interrupts_; }
  Wakeups(const Wakeups&) = delete;
  Wakeups& operator=(const Wakeups&) = delete;

  void clear() const noexcept { reg(kNvicClearPending) = interrupts_; }
  void sleep() const noexcept { asm volatile("wfi"); }

 private:
  uint32_t interrupts_;
};

}  // namespace hedgehog::firmware

// SPDX-License-Identifier: MIT
// From reset to `board_main`: the image is copied to SRAM, where it runs with interrupts masked for
// good. Every exception is an error and leaves the safe pins until the watchdog resets the chip.
#include <stddef.h>

#include "firmware/pins.h"
#include "firmware/registers.h"

extern "C" {
extern uint32_t stack_top[];
extern uint32_t image_begin[];
extern uint32_t image_end[];
extern uint32_t image_in_flash[];
extern uint32_t bss_begin[];
extern uint32_t bss_end[];

[[noreturn]] void board_main();

// What the compiler calls by itself in freestanding code.
void* memset(void* to, int value, size_t count) {
  auto* bytes = static_cast<volatile uint8_t*>(to);
  for (size_t i = 0; i < count; ++i) bytes[i] = static_cast<uint8_t>(value);
  return to;
}
void* memcpy(void* to, const void* from, size_t count) {
  auto* bytes = static_cast<volatile uint8_t*>(to);
  for (size_t i = 0; i < count; ++i) bytes[i] = static_cast<const uint8_t*>(from)[i];
  return to;
}

[[noreturn]] void fault_handler() {
  hedgehog::firmware::set_safe_pins();
  for (;;) {
  }
}

[[noreturn, gnu::section(".start.code")]] void reset_handler() {
  asm volatile("cpsid i");
  // Nothing is in SRAM yet that could be called.
  const volatile uint32_t* from = image_in_flash;
  for (volatile uint32_t* to = image_begin; to < image_end; ++to, ++from) *to = *from;
  for (volatile uint32_t* to = bss_begin; to < bss_end; ++to) *to = 0;
  hedgehog::firmware::reg(hedgehog::firmware::kVectorTable) =
      reinterpret_cast<uint32_t>(image_begin);
  // Flash and SRAM are too far apart for a plain call.
  void (*volatile enter)() = board_main;
  enter();
  for (;;) {
  }
}
}

namespace {

using Handler = void (*)();

/// Until the image is in SRAM: the pins are as in reset, and there is no watchdog yet.
[[noreturn, gnu::section(".start.code")]] void early_fault_handler() {
  for (;;) {
  }
}

/// What the second stage needs of a vector table, with NMI and HardFault (ARMv6-M Architecture
/// Reference Manual B1.5.3).
[[gnu::section(".start.vectors"), gnu::used]] const Handler kFlashVectors[] = {
    reinterpret_cast<Handler>(stack_top), reset_handler, early_fault_handler, early_fault_handler};

/// ARMv6-M Architecture Reference Manual B1.5.3: 16 exceptions and the 26 interrupts of 2.3.2.
struct Vectors {
  Handler stack = reinterpret_cast<Handler>(stack_top);
  Handler reset = reset_handler;
  Handler others[14 + 26];
};
constexpr Vectors all_faults() {
  Vectors vectors{};
  for (Handler& handler : vectors.others) handler = fault_handler;
  return vectors;
}
[[gnu::section(".vectors"), gnu::used]] const Vectors kVectors = all_faults();

}  // namespace

// SPDX-License-Identifier: MIT
#include "firmware/boot_loader.h"

#include "firmware/pins.h"
#include "firmware/registers.h"

namespace hedgehog::firmware {
namespace {

// 2.8.3: where the ROM keeps the addresses of its table of functions and of what looks them up.
constexpr uint32_t kFunctionTable = kRom + 0x14;
constexpr uint32_t kTableLookup = kRom + 0x18;
constexpr uint32_t kResetToUsbBoot = 'U' | 'B' << 8;

using Lookup = void (*(*)(uint32_t table, uint32_t code))(uint32_t, uint32_t);

uint32_t halfword(uint32_t address) noexcept {
  // The compiler takes addresses so low for an error.
  asm("" : "+l"(address));
  return *reinterpret_cast<const volatile uint16_t*>(address);
}

}  // namespace

void enter_boot_loader() noexcept {
  set_safe_pins();
  const auto look_up = reinterpret_cast<Lookup>(halfword(kTableLookup));
  const auto reset = look_up(halfword(kFunctionTable), kResetToUsbBoot);
  // No lamp, both interfaces. A ROM that came back would leave it to the watchdog.
  reset(0, 0);
  for (;;) {
  }
}

}  // namespace hedgehog::firmware

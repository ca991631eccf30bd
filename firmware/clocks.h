// SPDX-License-Identifier: MIT
// Clocks: 125 MHz for the processor and its peripherals, 48 MHz for USB, 1 MHz for timer and
// watchdog, all from the 12 MHz crystal.
#pragma once

namespace hedgehog::firmware {

void start_clocks() noexcept;

/// The peripherals of this board, out of reset.
void start_peripherals() noexcept;

/// The USB controller as after power-up, except for its memory.
void restart_usb() noexcept;

}  // namespace hedgehog::firmware

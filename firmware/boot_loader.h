// SPDX-License-Identifier: MIT
// The way into the boot loader of the ROM, which takes new firmware as mass storage and from
// picotool.
#pragma once

namespace hedgehog::firmware {

/// Safe pins, then a reset into the ROM, where nothing drives any pin. REQUIRES: pins were started.
[[noreturn]] void enter_boot_loader() noexcept;

}  // namespace hedgehog::firmware

// SPDX-License-Identifier: MIT
// Emulated devices and the kernel's host controller of USB/IP are hardware elsewhere, which does
// not wait for the machine's processor. In the guest, which has one processor, they would.
#pragma once

#include <sys/types.h>

namespace hedgehog::vm {

/// The emulator's process, and the two kernel threads of each plugged device, run before the
/// daemon's. To be called when a device was plugged.
void run_hardware_first(pid_t emulator);

}  // namespace hedgehog::vm

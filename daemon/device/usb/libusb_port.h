// SPDX-License-Identifier: MIT
// The USB of this machine through libusb: the thin part below the seam of usb_port.h.
#pragma once

#include <memory>

#include "daemon/device/usb/usb_port.h"

namespace hedgehog::device {

/// Lists by /sys, opens by libusb, each time with a context of its own (see usb_handle.h). Any
/// thread, one at a time.
std::unique_ptr<UsbBus> make_libusb_bus();

}  // namespace hedgehog::device

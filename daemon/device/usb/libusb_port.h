// SPDX-License-Identifier: MIT
// USB of this machine through libusb: a thin implementation of usb_port.h.
#pragma once

#include <memory>

#include "daemon/device/usb/usb_port.h"

namespace hedgehog::device {

/// Lists by /sys, opens by libusb, each time with its own context (see usb_handle.h). Any thread,
/// one at a time.
std::unique_ptr<UsbBus> make_libusb_bus();

}  // namespace hedgehog::device

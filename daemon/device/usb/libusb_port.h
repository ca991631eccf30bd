// SPDX-License-Identifier: MIT
// USB of this machine through libusb: a thin implementation of usb_port.h.
#pragma once

#include <memory>

#include "daemon/device/usb/usb_port.h"

namespace hedgehog::device {

/// Lists by /sys, opens by libusb, each with its own context (usb_handle.h). One thread at a time.
std::unique_ptr<UsbBus> make_libusb_bus();

}  // namespace hedgehog::device

// SPDX-License-Identifier: MIT
// Ports over libusb and hidapi: the thin part below the seam of port.h.
//
// A HID device is opened through its hidraw node when it has one. Where the kernel keeps the device
// to itself (hid-sensor-hub before Linux 6.3 leaves orientation sensors without a node), libusb
// takes the interface away from it instead.
#pragma once

#include <string>

#include "daemon/device/sensors/discovery.h"
#include "daemon/device/sensors/port.h"

namespace hedgehog::device {

/// Looks in /sys for the sensor and opens it. `serial` empty: any, as long as there is one only.
/// A missing permission is told apart from a missing device. Any thread.
OpenedHid open_hid(SensorKind kind, const std::string& serial);
OpenedBytes open_mti(const std::string& serial);

/// One device found before; REQUIRES: `device.hidraw` is not empty.
OpenedHid open_hidraw(const HidDevice& device);
/// REQUIRES: `device.usb`.
OpenedHid open_usb_hid(const HidDevice& device);
OpenedBytes open_usb_bytes(const UsbDevice& device);

}  // namespace hedgehog::device

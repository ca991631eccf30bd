// SPDX-License-Identifier: MIT
// Ports over libusb and hidapi: the thin part below the seam of port.h.
//
// A HID device is opened through its hidraw node when it has one. Where the kernel keeps the device
// to itself (hid-sensor-hub before Linux 6.3 leaves orientation sensors without a node), libusb
// takes the interface away from it instead.
#pragma once

#include <string>

#include "daemon/device/sensors/drivers.h"

namespace hedgehog::device {

/// What reads the sensor of that driver: it looks for it in /sys, `serial` empty: any, as long as
/// there is one only, and opens it. A missing permission is told apart from a missing device.
/// REQUIRES: the driver can read it. The driver outlives the sensor.
std::unique_ptr<Sensor> make_sensor(const SensorDriver& driver, const std::string& serial,
                                    const SensorSinks& sinks);

/// One device found before; REQUIRES: `device.hidraw` is not empty.
OpenedHid open_hidraw(const HidDevice& device);
/// REQUIRES: `device.usb`.
OpenedHid open_usb_hid(const HidDevice& device);
OpenedBytes open_usb_bytes(const UsbDevice& device);

}  // namespace hedgehog::device

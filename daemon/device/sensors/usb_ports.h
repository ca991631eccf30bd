// SPDX-License-Identifier: MIT
// Ports over libusb and hidapi: thin implementations of port.h.
//
// A HID device is opened through its hidraw node if it has one. If the kernel creates none
// (hid-sensor-hub before Linux 6.3 leaves orientation sensors without a node), libusb detaches the
// kernel driver from the interface instead.
#pragma once

#include <string>

#include "daemon/device/sensors/drivers.h"

namespace hedgehog::device {

/// Makes the sensor of that driver, which searches for it in /sys (`serial` empty: any, if there is
/// only one) and opens it. A missing permission is distinguished from a missing device. REQUIRES:
/// the driver can read it. The driver outlives the sensor.
std::unique_ptr<Sensor> make_sensor(const SensorDriver& driver, const std::string& serial,
                                    const SensorSinks& sinks);

/// A device found before; REQUIRES: `device.hidraw` is not empty.
OpenedHid open_hidraw(const HidDevice& device);
/// REQUIRES: `device.usb`.
OpenedHid open_usb_hid(const HidDevice& device);
OpenedBytes open_usb_bytes(const UsbDevice& device);

}  // namespace hedgehog::device

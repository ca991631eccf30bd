// SPDX-License-Identifier: MIT
// Ports over libusb and hidapi: thin implementations of port.h. A HID device without a hidraw node
// (hid-sensor-hub before Linux 6.3) is opened by libusb, which detaches the kernel driver.
#pragma once

#include <string>

#include "daemon/device/sensors/drivers.h"

namespace hedgehog::device {

/// Makes that driver's sensor, which searches for it in /sys (`serial` empty: any, if there is only
/// one) and opens it. REQUIRES: the driver can read it. The driver outlives the sensor.
std::unique_ptr<Sensor> make_sensor(const SensorDriver& driver, const std::string& serial,
                                    const SensorSinks& sinks);

OpenedHid open_hidraw(const HidDevice& device);   // REQUIRES: `device.hidraw` is not empty
OpenedHid open_usb_hid(const HidDevice& device);  // REQUIRES: `device.usb`
OpenedBytes open_usb_bytes(const UsbDevice& device);

}  // namespace hedgehog::device

// SPDX-License-Identifier: MIT
// The kinds of sensors that the daemon reads: name, detection on the buses, and reader. A driver is
// defined at the end of its sensor's file; any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/device/sensors/discovery.h"
#include "daemon/device/sensors/port.h"
#include "daemon/device/sensors/sensor.h"

namespace hedgehog::device {

enum class SensorJob : std::uint8_t { kOrientation, kThermometer };

/// Destinations of measurements. A sensor uses the one of its job.
struct SensorSinks {
  OrientationSink orientation;
  ThermometerSink thermometer;
};

/// A device is on USB or HID: one of the `matches_` is set, with the `make_` of the same name.
struct SensorDriver {
  std::string_view type;   // in the configuration and in `device.list`: "dualsense"
  std::string_view words;  // "DualSense pad"
  SensorJob job = SensorJob::kOrientation;
  bool (*matches_hid)(const HidDevice& device) = nullptr;
  bool (*matches_usb)(const UsbDevice& device) = nullptr;
  std::unique_ptr<Sensor> (*make_hid)(OpenHid open, const SensorSinks& sinks) = nullptr;
  std::unique_ptr<Sensor> (*make_usb)(OpenBytes open, const SensorSinks& sinks) = nullptr;
  /// Reason for which such a device cannot be read, and has no `make_`; empty: it can.
  std::string_view unusable = {};
};

extern const SensorDriver kDualSenseDriver;
extern const SensorDriver kDualShock4Driver;
extern const SensorDriver kHidSensorDriver;
extern const SensorDriver kMtiDriver;
extern const SensorDriver kTemperDriver;
extern const SensorDriver kClosedXsensDriver;  // Xsens radio stations and converters

/// All drivers. If two match a device, the later one is used.
std::span<const SensorDriver* const> sensor_drivers() noexcept;

const SensorDriver* driver_of(const HidDevice& device);  // nullptr: not a sensor
const SensorDriver* driver_of(const UsbDevice& device);

/// The device of that kind, or of that kind and serial number: an index into `devices`, or a
/// sentence with the reason for which there is none, or more than one.
struct Found {
  std::optional<std::size_t> index;
  std::string failure;
};
Found find_sensor(const std::vector<HidDevice>& devices, const SensorDriver& driver,
                  const std::string& serial);
Found find_sensor(const std::vector<UsbDevice>& devices, const SensorDriver& driver,
                  const std::string& serial);

}  // namespace hedgehog::device

// SPDX-License-Identifier: MIT
// Sensors in addition to the board's, and their mounting in the ball. Plain values; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "daemon/device/imu/mounting.h"
#include "daemon/device/sensors/drivers.h"
#include "daemon/device/thermometer/sample.h"

namespace hedgehog::config {

enum class ImuType : std::uint8_t { kNone, kSimulator, kExternal, kSensor };

/// Source of the orientation.
struct ImuSource {
  ImuSource(ImuType source) noexcept : type(source) {}
  ImuSource(const device::SensorDriver* sensor) noexcept : type(ImuType::kSensor), driver(sensor) {}
  friend bool operator==(const ImuSource&, const ImuSource&) = default;

  ImuType type;
  /// Only for `kSensor`.
  const device::SensorDriver* driver = nullptr;
};
/// Name in the file: "hid_sensor".
std::string_view name(const ImuSource& source) noexcept;

/// Serial number of the sensor, and its sides towards the ball's front and up.
struct ImuFitting {
  /// Empty: any connected one.
  std::string serial;
  device::Side front = device::Side::kFront;
  device::Side up = device::Side::kUp;
  friend bool operator==(const ImuFitting&, const ImuFitting&) = default;
};

struct ThermometerSettings {
  /// nullptr: no thermometer.
  const device::SensorDriver* driver = nullptr;
  device::ThermometerRole role = device::ThermometerRole::kNone;
  std::string serial;
  friend bool operator==(const ThermometerSettings&, const ThermometerSettings&) = default;
};

}  // namespace hedgehog::config

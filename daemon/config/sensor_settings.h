// SPDX-License-Identifier: MIT
// Which sensors there are besides the board's, and how they sit in the ball. Plain values; any
// thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "daemon/device/imu/mounting.h"
#include "daemon/device/sensors/drivers.h"
#include "daemon/device/thermometer/sample.h"

namespace hedgehog::config {

enum class ImuType : std::uint8_t { kNone, kSimulator, kExternal, kSensor };

/// Where the orientation comes from.
struct ImuSource {
  ImuSource(ImuType source) noexcept : type(source) {}
  ImuSource(const device::SensorDriver* sensor) noexcept : type(ImuType::kSensor), driver(sensor) {}
  friend bool operator==(const ImuSource&, const ImuSource&) = default;

  ImuType type;
  /// Of `kSensor`.
  const device::SensorDriver* driver = nullptr;
};
/// As in the file: "hid_sensor".
std::string_view name(const ImuSource& source) noexcept;

/// Which one, and which of its sides look to the ball's front and up.
struct ImuFitting {
  /// Empty: whichever is connected.
  std::string serial;
  device::Side front = device::Side::kFront;
  device::Side up = device::Side::kUp;
  friend bool operator==(const ImuFitting&, const ImuFitting&) = default;
};

struct ThermometerSettings {
  /// nullptr: there is none.
  const device::SensorDriver* driver = nullptr;
  device::ThermometerRole role = device::ThermometerRole::kNone;
  std::string serial;
  friend bool operator==(const ThermometerSettings&, const ThermometerSettings&) = default;
};

}  // namespace hedgehog::config

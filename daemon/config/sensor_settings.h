// SPDX-License-Identifier: MIT
// Which sensors there are besides the board's, and how they sit in the ball. Plain values; any
// thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "daemon/device/imu/mounting.h"
#include "daemon/device/thermometer/sample.h"

namespace hedgehog::config {

enum class ImuType : std::uint8_t {
  kNone,
  kSimulator,
  kExternal,
  kHidSensor,
  kDualSense,
  kDualShock4,
  kMti,
};
/// As in the file: "hid_sensor".
std::string_view name(ImuType type) noexcept;

/// Which one, and which of its sides look to the ball's front and up.
struct ImuFitting {
  /// Empty: whichever is connected.
  std::string serial;
  device::Side front = device::Side::kFront;
  device::Side up = device::Side::kUp;
  friend bool operator==(const ImuFitting&, const ImuFitting&) = default;
};

enum class ThermometerType : std::uint8_t { kNone, kTemper };

struct ThermometerSettings {
  ThermometerType type = ThermometerType::kNone;
  device::ThermometerRole role = device::ThermometerRole::kNone;
  std::string serial;
  friend bool operator==(const ThermometerSettings&, const ThermometerSettings&) = default;
};

}  // namespace hedgehog::config

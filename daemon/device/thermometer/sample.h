// SPDX-License-Identifier: MIT
// Last sample of the second thermometer, and its role.
#pragma once

#include <cstdint>

#include "model/tick.h"

namespace hedgehog::device {

enum class ThermometerRole : std::uint8_t {
  kNone,   // not present
  kCoil,   // beside the coil sensor, to check it
  kShell,  // under the skin, to protect the hand
};

/// Trivially copyable; written by the thermometer's thread, read by control.
struct ThermometerSample {
  /// False: no sample yet.
  bool present = false;
  double celsius = 0.0;
  /// Tick of the measurement.
  model::Tick stamp = 0;
};

}  // namespace hedgehog::device

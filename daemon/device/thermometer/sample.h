// SPDX-License-Identifier: MIT
// Last sample of the second thermometer, and its role.
#pragma once

#include <cstdint>

#include "model/tick.h"

namespace hedgehog::device {

enum class ThermometerRole : std::uint8_t {
  kNone,   // there is none
  kCoil,   // beside the coil sensor, to check it
  kShell,  // under the skin, to keep the hand from harm
};

/// Trivially copyable; written by the thermometer's reader, read by control.
struct ThermometerSample {
  /// False: no sample yet.
  bool present = false;
  double celsius = 0.0;
  /// When it was measured.
  model::Tick stamp = 0;
};

}  // namespace hedgehog::device

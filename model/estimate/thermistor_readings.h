// SPDX-License-Identifier: MIT
// Readings of the thermistors on the windings: one, or one on each.
#pragma once

#include <array>
#include <cstddef>

#include "model/coils.h"

namespace hedgehog::model {

/// By winding. Trivially copyable.
struct ThermistorReadings {
  std::array<double, kCoils> celsius{25.0, 25.0, 25.0};
  std::array<bool, kCoils> valid{};  // false where there is none, or where it cannot be used

  int count() const noexcept { return valid[0] + valid[1] + valid[2]; }
};

/// The thermistor reading that equals the temperature of a winding at rest.
struct ThermistorReference {
  double celsius = 25.0;
  bool valid = false;
};

/// Reference of winding `coil` (0..2): its own thermistor where there is more than one; otherwise
/// the one on `sensor_winding`, which is valid for another winding only while all windings are at
/// rest.
inline ThermistorReference reference_of(const ThermistorReadings& thermistors, int coil,
                                        int sensor_winding, bool all_at_rest) noexcept {
  const bool own = thermistors.count() > 1;
  const auto shown = static_cast<std::size_t>(own ? coil : sensor_winding);
  return {thermistors.celsius[shown], thermistors.valid[shown] && (own || all_at_rest)};
}

}  // namespace hedgehog::model

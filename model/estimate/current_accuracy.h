// SPDX-License-Identifier: MIT
// Accuracy of a board's current measurement.
#pragma once

namespace hedgehog::model {

/// Trivially copyable.
struct CurrentAccuracy {
  double noise_a = 0.0;   // standard deviation of one reading
  double offset_a = 0.0;  // maximum, common to all readings
  bool signs = true;      // the sign is measured too

  friend constexpr bool operator==(const CurrentAccuracy&,
                                   const CurrentAccuracy&) noexcept = default;
};

/// Amplifiers in the windings' leads, and the drivers' CS pins (daemon/device/simulator/README.md).
inline constexpr CurrentAccuracy kInLineAccuracy{0.05, 0.03, true};
inline constexpr CurrentAccuracy kDriverCsAccuracy{0.12, 0.12, false};

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// Accuracy of a board's current measurement.
#pragma once

namespace hedgehog::model {

/// Trivially copyable.
struct CurrentAccuracy {
  /// Standard deviation of one reading, and maximum offset common to all readings, A.
  double noise_a = 0.0;
  double offset_a = 0.0;
  /// The sign is measured too.
  bool signs = true;

  friend constexpr bool operator==(const CurrentAccuracy&,
                                   const CurrentAccuracy&) noexcept = default;
};

/// In-line amplifiers in the windings' leads, and the drivers' CS pins, each with 12-bit converters
/// (figures: daemon/device/simulator/README.md).
inline constexpr CurrentAccuracy kInLineAccuracy{0.05, 0.03, true};
inline constexpr CurrentAccuracy kDriverCsAccuracy{0.12, 0.12, false};

}  // namespace hedgehog::model

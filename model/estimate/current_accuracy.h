// SPDX-License-Identifier: MIT
// How well a board's electronics know the currents of the windings.
#pragma once

namespace hedgehog::model {

/// Trivially copyable.
struct CurrentAccuracy {
  /// Standard deviation of one reading, and the most that all readings may be off by, A.
  double noise_a = 0.0;
  double offset_a = 0.0;
  /// The sign is measured too.
  bool signs = true;

  friend constexpr bool operator==(const CurrentAccuracy&,
                                   const CurrentAccuracy&) noexcept = default;
};

/// Amplifiers in the windings' leads, and the drivers' own CS pins, with their 12-bit converters
/// (daemon/device/simulator/README.md has the figures).
inline constexpr CurrentAccuracy kInLineAccuracy{0.05, 0.03, true};
inline constexpr CurrentAccuracy kDriverCsAccuracy{0.12, 0.12, false};

}  // namespace hedgehog::model

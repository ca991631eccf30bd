// SPDX-License-Identifier: MIT
// Uncertainty of a ball and its electronics relative to their device file.
#pragma once

namespace hedgehog::model {

/// From the device file (`uncertainty`); the defaults are those of an uncalibrated ball. Trivially
/// copyable. A tolerance t, within which all values are equally likely, has a standard deviation of
/// 0.58 t.
struct ThermalUncertainty {
  /// Relative tolerance of heat capacities and thermal resistances.
  double thermal = 0.2;
  /// Relative standard deviation of R25 including the gains of voltage and current.
  double resistance = 0.03;
  /// Standard deviation of the thermistors' offsets, K.
  double thermistor_k = 0.5;

  friend constexpr bool operator==(const ThermalUncertainty&,
                                   const ThermalUncertainty&) noexcept = default;
};

/// Minimum for any device file: the electronics' gains drift by as much, and the fault campaigns
/// used no less.
inline constexpr ThermalUncertainty kMinUncertainty{0.05, 0.01, 0.3};
inline constexpr ThermalUncertainty kMaxUncertainty{0.5, 0.2, 3.0};

}  // namespace hedgehog::model

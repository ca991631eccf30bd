// SPDX-License-Identifier: MIT
// Uncertainty of a ball and its electronics relative to their device file.
#pragma once

namespace hedgehog::model {

/// From the device file; defaults: an uncalibrated ball. A tolerance t, within which all values are
/// equally likely, has a standard deviation of 0.58 t. Trivially copyable.
struct ThermalUncertainty {
  double thermal = 0.2;      // relative tolerance of heat capacities and thermal resistances
  double resistance = 0.03;  // relative standard deviation of R25 with gains of voltage and current
  double thermistor_k = 0.5;  // standard deviation of the thermistors' offsets

  friend constexpr bool operator==(const ThermalUncertainty&,
                                   const ThermalUncertainty&) noexcept = default;
};

/// For any device file: the electronics' gains drift by as much; the fault campaigns used no less.
inline constexpr ThermalUncertainty kMinUncertainty{0.05, 0.01, 0.3};
inline constexpr ThermalUncertainty kMaxUncertainty{0.5, 0.2, 3.0};

}  // namespace hedgehog::model

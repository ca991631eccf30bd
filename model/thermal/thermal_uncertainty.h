// SPDX-License-Identifier: MIT
// By how much a ball and its electronics may differ from their device file.
#pragma once

namespace hedgehog::model {

/// Of the device file (`uncertainty`), else those of a ball that nobody has calibrated. Trivially
/// copyable. A tolerance t, within which all values are equally likely, has a standard
/// deviation of 0.58 t.
struct ThermalUncertainty {
  /// Tolerance of heat capacities and thermal resistances, a share.
  double thermal = 0.2;
  /// Standard deviation of R25 with the gains of voltage and current, a share.
  double resistance = 0.03;
  /// The same of the thermistors' offsets, K.
  double thermistor_k = 0.5;

  friend constexpr bool operator==(const ThermalUncertainty&,
                                   const ThermalUncertainty&) noexcept = default;
};

/// Less is not believed of any device file: gains of the electronics drift by as much, and the
/// fault campaigns were run with no less.
inline constexpr ThermalUncertainty kMinUncertainty{0.05, 0.01, 0.3};
inline constexpr ThermalUncertainty kMaxUncertainty{0.5, 0.2, 3.0};

}  // namespace hedgehog::model

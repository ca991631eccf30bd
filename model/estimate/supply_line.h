// SPDX-License-Identifier: MIT
// The power supply as the board's voltage reading shows it: its voltage without load, and how
// steady that is.
#pragma once

namespace hedgehog::model {

/// Of a supply with its leads, typically, ohm.
inline constexpr double kSupplySourceOhm = 0.02;
/// A sound supply's voltage without load stays within this share of its mean.
inline constexpr double kSupplyRegulation = 0.012;

/// Voltage without load, V, of a supply that delivers `current_a` at `voltage_v`.
constexpr double open_voltage(double voltage_v, double current_a) noexcept {
  return voltage_v + kSupplySourceOhm * current_a;
}

}  // namespace hedgehog::model

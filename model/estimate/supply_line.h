// SPDX-License-Identifier: MIT
// Model of the power supply behind the board's voltage reading: its no-load voltage and regulation.
#pragma once

namespace hedgehog::model {

inline constexpr double kSupplySourceOhm = 0.02;  // typical, with leads
/// The no-load voltage of an intact supply stays within this share of its mean.
inline constexpr double kSupplyRegulation = 0.012;

/// No-load voltage of a supply that delivers `current_a` at `voltage_v`.
constexpr double open_voltage(double voltage_v, double current_a) noexcept {
  return voltage_v + kSupplySourceOhm * current_a;
}

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// The board's own limits: the last protection when every other layer fails. They are built into the
// firmware for one kind of ball; a Limits frame can only tighten them, until the next power-up.
#pragma once

#include <stdint.h>

namespace hedgehog::board {

// Derivation of the I^2 t budgets. Each is a leaky sum, dq/dt = I^2 - q / tau, tripping at Q.
// With the nominal ball (model/thermal-model.md) at an ambient temperature of 18 C, full demand
// for 90 minutes along one winding, two or all three, and the ideal limiter law, the maximum of q
// is
//   one winding's I^2, tau = 131 s:  7418 A^2 s     (balls 20 % stronger: 8841)
//   |I|^2 of all,      tau = 524 s: 23644 A^2 s     (balls 20 % stronger: 28219)
// and 1.3 times that is Q. A single winding needs its own sum, because 15 A shared by three may
// flow three times as long; and the whole needs one, because the three share one core. Of the taus
// of 2^15..2^20 ms (powers of two, so that the leak is a shift), these keep the windings coolest
// when the limiter *and* the thermistor have failed: 128 C at worst (8 A along one winding without
// end), 98 C at 15 A along one.

/// tau = 2^kWindingTauShift ms and 2^kDeviceTauShift ms.
inline constexpr int kWindingTauShift = 17;
inline constexpr int kDeviceTauShift = 19;

/// Trivially copyable.
struct BoardLimits {
  /// Thermistor, hundredths of a degree; exceeded for kSensorHotMs.
  int16_t sensor_cc = 7500;
  /// Euclidean norm of the measured currents; exceeded for kOverCurrentMs.
  uint16_t current_ma = 16500;
  /// Q of the two budgets, A^2 s.
  uint32_t winding_a2s = 9640;
  uint32_t device_a2s = 30700;
  /// The bridges' range (Pololu G2 18v17: 6.5..30 V). Above it for kSupplyMs the supply switch
  /// opens.
  uint16_t supply_min_mv = 6500;
  uint16_t supply_max_mv = 30000;
  /// The switch closes once the supply has been in this range for so long, after power-up and after
  /// a supply that was too high. 0: closed at power-up at any voltage.
  uint16_t supply_settled_ms = 0;
  /// Minimum resistance of a winding: 0.45 ohm at 25 C less 20 %.
  uint16_t min_resistance_mohm = 360;
  /// In the brake a current decays by at least one part in this per millisecond: L / R of the
  /// slowest winding, in ms, rounded up. Neither this nor the resistance may be 0.
  uint16_t decay_ms = 5;
};

/// The dead-man: the board is safe this long after the last valid set-point.
inline constexpr uint32_t kDeadManMs = 100;
inline constexpr uint32_t kOverCurrentMs = 50;
inline constexpr uint32_t kSensorHotMs = 50;
/// Thermistor open or short, and supply out of range, for this long: ignores one disturbed
/// conversion.
inline constexpr uint32_t kSensorBrokenMs = 20;
inline constexpr uint32_t kSupplyMs = 10;
/// FLT of a bridge: ignores a spike on the open-drain line.
inline constexpr uint32_t kBridgeFaultMs = 3;
/// Current while the bridges sleep.
inline constexpr uint32_t kStuckMs = 20;
inline constexpr uint32_t kStuckMa = 500;
/// The same in the supply line, where a short duty draws less current than the winding carries.
inline constexpr uint32_t kStuckSupplyMa = 150;
/// The bridges' capacitors (3.6 mF) charge through the supply line when the switch closes: at 12 V
/// from a supply limited to 1 A, half of which the fan may take, in 95 ms. Until then only the
/// amplifiers in the windings' leads detect a stuck bridge.
inline constexpr uint32_t kChargingMs = 200;
/// More current in a winding than its duty can drive through the minimum resistance: a stuck PWM
/// line, or a bridge that does not follow its input. Detected less than 25 ms after a winding at 15
/// A should be idle, 5 ms after one that was idle.
inline constexpr uint32_t kUnexpectedMs = 5;
inline constexpr uint32_t kUnexpectedMa = 500;
/// More current drawn from the supply than the windings carry: a current sensor does not detect
/// one.
inline constexpr uint32_t kExcessSupplyMs = 20;
inline constexpr uint32_t kExcessSupplyMa = 1500;
/// The same for the means of both, with a time constant of 2^kSupplyMeanShift ms, where tolerances
/// alone remain: in random play on the simulator, with its tolerances, the excess beyond the eighth
/// is 0.03 A at most with amplifiers in the windings' leads, 0.11 A with the drivers' own sensors.
/// Slow, so that the host, which names the winding, trips first.
inline constexpr int kSupplyMeanShift = 11;
inline constexpr uint32_t kExcessSupplyMeanMa = 400;
/// A winding driven in one direction by this duty (8 %, 2 A) carries a current that the driver's
/// own sensor detects after 5 L / R; without a reading for this long the sensor or its line is
/// broken.
inline constexpr uint32_t kMinDrivenDutyQ15 = 2622;
inline constexpr uint32_t kUnmeasuredMs = 25;
/// Time for which the bridges must have slept before the boot loader: 15 A have decayed by then,
/// and opening the supply switch interrupts no current.
inline constexpr uint32_t kBootLoaderMs = 20;
/// The fan runs above this after power-up, without a host.
inline constexpr int16_t kFanFromCc = 4000;

}  // namespace hedgehog::board

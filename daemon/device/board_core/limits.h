// SPDX-License-Identifier: MIT
// The board's own limits: the last word when everything above it is wrong. They hold for one kind
// of ball and live in its firmware; a Limits frame can only tighten them, until the next power-up.
#pragma once

#include <stdint.h>

namespace hedgehog::board {

// How the I^2 t budgets were chosen. Each is a leaky sum, dq/dt = I^2 - q / tau, tripping at Q.
// With the nominal ball (model/thermal-model.md) in a room of 18 C, full demand held for 90 minutes
// along one winding, two or all three, and the ideal limiter law, the most that q reaches is
//   one winding's I^2, tau = 131 s:  7418 A^2 s     (balls 20 % stronger: 8841)
//   |I|^2 of all,      tau = 524 s: 23644 A^2 s     (balls 20 % stronger: 28219)
// and 1.3 times that is Q. A single winding needs its own sum, because 15 A shared by three may
// flow three times as long; and the whole needs one, because the three share one core. The taus
// (powers of two milliseconds, so that the leak is a shift) are those which, of 2^15..2^20 ms,
// leave the windings coolest when the limiter *and* the thermistor have failed: 128 C at worst (8 A
// along one winding for ever), 98 C at 15 A along one.

/// tau = 2^kWindingTauShift ms and 2^kDeviceTauShift ms.
inline constexpr int kWindingTauShift = 17;
inline constexpr int kDeviceTauShift = 19;

/// Trivially copyable.
struct BoardLimits {
  /// Thermistor, hundredths of a degree; for kSensorHotMs.
  int16_t sensor_cc = 7500;
  /// Euclidean norm of the measured currents; for kOverCurrentMs.
  uint16_t current_ma = 16500;
  /// Q of the two budgets, A^2 s.
  uint32_t winding_a2s = 9640;
  uint32_t device_a2s = 30700;
  /// The bridges' range (Pololu G2 18v17: 6.5..30 V).
  uint16_t supply_min_mv = 6500;
  uint16_t supply_max_mv = 30000;
  /// No winding has less: 0.45 ohm at 25 C less 20 %.
  uint16_t min_resistance_mohm = 360;
  /// A current dies away in the brake by at least one part in this a millisecond: L / R, in ms and
  /// rounded up, of the slowest winding. Neither this nor the resistance may be 0.
  uint16_t decay_ms = 5;
};

/// The dead-man: this long after the last valid set-point the board is safe.
inline constexpr uint32_t kDeadManMs = 100;
inline constexpr uint32_t kOverCurrentMs = 50;
inline constexpr uint32_t kSensorHotMs = 50;
/// Thermistor open or short, and supply out of range, for this long: not one disturbed conversion.
inline constexpr uint32_t kSensorBrokenMs = 20;
inline constexpr uint32_t kSupplyMs = 10;
/// FLT of a bridge: long enough to ignore a spike on the open-drain line.
inline constexpr uint32_t kBridgeFaultMs = 3;
/// Current that flows although the bridges sleep.
inline constexpr uint32_t kStuckMs = 20;
inline constexpr uint32_t kStuckMa = 500;
/// The same in the supply line, where a short duty draws less than it drives.
inline constexpr uint32_t kStuckSupplyMa = 150;
/// More current in a winding than its duty can drive through the least resistance: a PWM line that
/// is stuck, or a bridge that does not obey. Found less than 25 ms after a winding at 15 A should
/// be idle, 5 ms when it was.
inline constexpr uint32_t kUnexpectedMs = 5;
inline constexpr uint32_t kUnexpectedMa = 500;
/// More current drawn from the supply than the windings carry: a current sensor does not see one.
inline constexpr uint32_t kExcessSupplyMs = 20;
inline constexpr uint32_t kExcessSupplyMa = 1500;
/// A winding that is driven one way by this duty (8 %, two amperes) carries a current that a
/// driver's own sensor sees after 5 L / R; when it does not for so long, the sensor or its line is
/// broken.
inline constexpr uint32_t kMinDrivenDutyQ15 = 2622;
inline constexpr uint32_t kUnmeasuredMs = 25;
/// For the boot loader the bridges must have slept for so long: 15 A have died away by then, and
/// opening the supply switch breaks none.
inline constexpr uint32_t kBootLoaderMs = 20;
/// After power-up, without a host: the fan runs above this.
inline constexpr int16_t kFanFromCc = 4000;

}  // namespace hedgehog::board

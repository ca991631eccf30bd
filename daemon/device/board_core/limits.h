// SPDX-License-Identifier: MIT
// The board's own limits, the last layer of protection: built into the firmware for one kind of
// ball. A Limits frame can only tighten them, until the next power-up.
#pragma once

#include <stdint.h>

namespace hedgehog::board {

// Derivation of the I^2 t budgets. Each is a leaky sum, dq/dt = I^2 - q / tau, tripping at Q = 1.3
// times the maximum of q with the nominal ball (model/thermal-model.md) at 18 C ambient, full
// demand for 90 minutes along one winding, two or all three, and the ideal limiter law:
//   one winding's I^2, tau = 131 s:  7418 A^2 s     (balls 20 % stronger: 8841)
//   |I|^2 of all,      tau = 524 s: 23644 A^2 s     (balls 20 % stronger: 28219)
// A single winding needs its own sum, because 15 A shared by three may flow three times as long;
// the whole needs one, because the three share one core. Of the taus of 2^15..2^20 ms these keep
// the windings coolest when the limiter *and* the thermistor have failed: 128 C at worst (8 A along
// one winding without end), 98 C at 15 A along one.

inline constexpr int kWindingTauShift = 17;  // tau = 2^shift ms
inline constexpr int kDeviceTauShift = 19;   // the same

/// Trivially copyable.
struct BoardLimits {
  int16_t sensor_cc = 7500;     // thermistor, 1/100 C; trips when exceeded for kSensorHotMs
  uint16_t current_ma = 16500;  // Euclidean norm; trips when exceeded for kOverCurrentMs
  uint32_t winding_a2s = 9640;  // Q of one winding
  uint32_t device_a2s = 30700;  // Q of the whole device
  /// The bridges' range (Pololu G2 18v17). Above it for kSupplyMs the supply switch opens.
  uint16_t supply_min_mv = 6500;
  uint16_t supply_max_mv = 30000;
  /// Time in that range until the switch closes, after power-up and after a supply that was too
  /// high. 0: closed at power-up at any voltage.
  uint16_t supply_settled_ms = 0;
  uint16_t min_resistance_mohm = 360;  // 0.45 ohm at 25 C less 20 %; not 0
  /// In the brake a current decays by at least one part in this per millisecond: L / R of the
  /// slowest winding, in ms, rounded up; not 0.
  uint16_t decay_ms = 5;
};

inline constexpr uint32_t kDeadManMs = 100;  // safe so long after the last valid set-point
inline constexpr uint32_t kOverCurrentMs = 50;
inline constexpr uint32_t kSensorHotMs = 50;
inline constexpr uint32_t kSensorBrokenMs = 20;  // open or short; ignores one disturbed conversion
inline constexpr uint32_t kSupplyMs = 10;        // out of range; likewise
inline constexpr uint32_t kBridgeFaultMs = 3;    // FLT; ignores a spike on the open-drain line
inline constexpr uint32_t kStuckMs = 20;         // current while the bridges sleep
inline constexpr uint32_t kStuckMa = 500;
inline constexpr uint32_t kStuckSupplyMa = 150;  // in the supply line: a short duty draws less
/// The bridges' capacitors (3.6 mF) charge when the switch closes, in 95 ms at 12 V with 0.5 A.
/// Until then only the amplifiers in the windings' leads detect a stuck bridge.
inline constexpr uint32_t kChargingMs = 200;
/// More current in a winding than its duty can drive through the minimum resistance: a stuck PWM
/// line or bridge. Detected within 25 ms after 15 A should end, within 5 ms in an idle winding.
inline constexpr uint32_t kUnexpectedMs = 5;
inline constexpr uint32_t kUnexpectedMa = 500;
/// More current drawn from the supply than the windings carry: a current sensor detects none.
inline constexpr uint32_t kExcessSupplyMs = 20;
inline constexpr uint32_t kExcessSupplyMa = 1500;
/// The same for the means of both (time constant 2^shift ms), where only tolerances remain: in
/// random play on the simulator the excess beyond the eighth is at most 0.03 A with amplifiers in
/// the leads, 0.11 A with CS. Slow, so that the host, which names the winding, trips first.
inline constexpr int kSupplyMeanShift = 11;
inline constexpr uint32_t kExcessSupplyMeanMa = 400;
/// At this duty (8 %, 2 A) in one direction the driver's own sensor detects the current after 5 L /
/// R; without a reading for this long the sensor or its line is broken.
inline constexpr uint32_t kMinDrivenDutyQ15 = 2622;
inline constexpr uint32_t kUnmeasuredMs = 25;
/// Sleep of the bridges before the boot loader: 15 A have decayed by then, and opening the supply
/// switch interrupts no current.
inline constexpr uint32_t kBootLoaderMs = 20;
inline constexpr int16_t kFanFromCc = 4000;  // without a host the fan runs above this

}  // namespace hedgehog::board

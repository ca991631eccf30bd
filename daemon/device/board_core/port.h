// SPDX-License-Identifier: MIT
// Conversion between the rules and the pins of a board with three Pololu G2 18v17 drivers, a 10 k
// NTC and a four-wire fan. Integer, freestanding: a firmware adds only the register access.
//
// Pins (electrical side: wiring.md beside this file), three times:
//   PWM  out  timer channel, 20 kHz or more; low = brake
//   DIR  out  low = current A -> B, counted as positive here
//   SLP  out  one for all three drivers; high = awake; pulled down by a resistor, asleep in reset
//   FLT  in   low = fault; open drain, pulled up
//   CS   in   converter, in the middle of the PWM's on-time; or, better, an amplifier across a
//             shunt in the winding's lead
// and once: supply voltage and supply current of the bridges (converter), one to three NTCs
// (converter), the fan's PWM (25 kHz, not inverted) and tach (2 pulses a turn), the supply switch.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "daemon/device/board_core/board_core.h"

namespace hedgehog::board {

enum class CurrentSense : uint8_t {
  kDriverCs,  // CS pin of the driver: magnitude without the sign, only while it drives
  kInLine,    // PWM-rejecting amplifier at a shunt in the winding's lead: with sign, always
};

/// Differences between boards. Converter values are 0..adc_full. The defaults are three drivers
/// with their own CS and one thermistor.
struct Wiring {
  uint16_t adc_full = 4095;
  uint16_t adc_reference_mv = 3300;  // at adc_full; also at the NTC's pull-up, so that it cancels
  CurrentSense current_sense = CurrentSense::kDriverCs;
  /// Of each winding; the gain at least 1000. CS of the 18v17: about 20 mV/A and 50 mV; to be
  /// calibrated, because that zero alone is 2.5 A.
  uint32_t current_uv_per_a[kWindings] = {20'000, 20'000, 20'000};
  int32_t current_zero_uv[kWindings] = {50'000, 50'000, 50'000};
  /// Time from each conversion to the last one of a current, below 1000; the currents are
  /// extrapolated to there from the millisecond before. 0: negligible.
  uint16_t converted_before_us[kWindings] = {};
  /// Shunt in the supply line of the bridges, without fan and electronics; 0: not fitted. With CS a
  /// stuck bridge is then not detected during sleep, and the supply switch has no use.
  uint32_t shunt_uv_per_a = 0;
  uint16_t supply_upper_ohm = 47000;  // supply = pin x (upper + lower) / lower
  uint16_t supply_lower_ohm = 4700;
  /// NTCs of 10 k at 25 C, B = 3950 K, from the pin to ground: 1, on the winding that the device
  /// file specifies, or 3, one on each winding in their order.
  uint8_t thermistors = 1;
  uint16_t ntc_pull_up_ohm = 10000;
  uint16_t pwm_top = 2399;  // the PWM timer counts 0..pwm_top
  uint16_t fan_top = 1919;
};

/// The reference board: an INA240A2 (gain 50) across 1 mOhm in each winding's lead, its zero at
/// half the reference; a supply shunt; three thermistors; a 12-bit converter (MCP3208).
constexpr Wiring reference_wiring() noexcept {
  Wiring wiring;
  wiring.current_sense = CurrentSense::kInLine;
  for (int k = 0; k < kWindings; ++k) {
    wiring.current_uv_per_a[k] = 50'000;
    wiring.current_zero_uv[k] = 1'650'000;
    // In the middle of the on-time, in three periods of the PWM one after the other.
    wiring.converted_before_us[k] = static_cast<uint16_t>(50 * (kWindings - 1 - k));
  }
  wiring.shunt_uv_per_a = 100'000;
  wiring.thermistors = 3;
  return wiring;
}

/// The reference board's clamp (SMCJ18A) stands 18 V and conducts from 20 V on: 24 V would burn it.
constexpr BoardLimits reference_limits() noexcept {
  BoardLimits limits;
  limits.supply_max_mv = 18'000;
  limits.supply_settled_ms = 20;
  return limits;
}

/// Below this duty the on-time is shorter than the 2 us of 50 us that the CS amplifier needs.
inline constexpr int16_t kMinSampledDutyQ15 = 1311;
/// CS readings above these of a bridge that is not driven, or too shortly to be sampled, are a
/// current without a set-point (a stuck PWM line).
inline constexpr int16_t kUndrivenMa = 500;
inline constexpr int16_t kShortlyDrivenMa = 2500;
/// CS so far below its zero: a current against the bridge's direction, of unknown magnitude.
inline constexpr int16_t kOpposedMa = -250;

/// One millisecond of measurements, as read from the peripherals.
struct RawInputs {
  /// CS: of the most recent complete on-time. In the winding's lead: the last conversion.
  uint16_t current_adc[kWindings] = {};
  uint16_t supply_adc = 0;
  uint16_t shunt_adc = 0;
  uint16_t ntc_adc[kWindings] = {};
  bool ntc_converted = false;   // all wired thermistors, since the last millisecond
  uint8_t faults_low = 0;       // bit k: FLT of driver k is low
  uint32_t tach_period_us = 0;  // between the last two falling edges; 0: none for 250 ms
};

/// Pin states until the next millisecond.
struct PinOutputs {
  uint16_t pwm[kWindings] = {};  // compare values, 0..pwm_top
  bool reverse[kWindings] = {};  // DIR is high
  bool awake = false;
  bool supply_switch_closed = true;
  uint16_t fan_pwm = 0;
};

/// The safe pin states: required after reset, and set by a fault handler.
constexpr PinOutputs safe_pins(const Wiring& wiring) noexcept {
  PinOutputs pins;
  pins.fan_pwm = wiring.fan_top;
  return pins;
}

/// Inputs of the rules. `applied` is the last result of `BoardCore::step`, `last` the previous
/// measurements (null: none). CS gets the sign of the bridge's direction; it is not valid while the
/// bridge brakes or sleeps: that current counts as not measured unless CS reads one.
BoardInputs measured(const Wiring& wiring, const RawInputs& raw, const BoardOutputs& applied,
                     const BoardInputs* last = nullptr) noexcept;

PinOutputs pins_for(const Wiring& wiring, const BoardOutputs& outputs) noexcept;

/// 1/100 C, of an NTC under a pull-up of `pull_up_ohm`. Within 0.2 K from 0 to 100 C, 0.6 K from
/// -40 to 125 C; clamped beyond.
int16_t ntc_cc(uint16_t adc, uint16_t adc_full, uint16_t pull_up_ohm) noexcept;

/// The millisecond of a firmware. `Port` has:
///   size_t receive(uint8_t* packet, size_t room)   the next packet of the host, 0: none
///   void   measure(RawInputs& raw)
///   void   apply(const PinOutputs& pins)
///   void   send(const uint8_t* frame)              64 bytes; dropped if the last is still waiting
/// Call it from the main loop on a 1 kHz tick, and feed the hardware watchdog (20 ms or less) only
/// there: then a loop that hangs is a reset, and reset is SLP low.
template <class Port>
void board_millisecond(BoardCore& core, const Wiring& wiring, Port& port) noexcept {
  uint8_t packet[kFrameSize + 1];  // one byte more, to detect longer packets
  // A host sends two a millisecond; a flood may not keep the board from its rules.
  for (int i = 0; i < 4; ++i) {
    const size_t length = port.receive(packet, sizeof(packet));
    if (length == 0) break;
    core.receive(packet, length);
  }
  RawInputs raw;
  port.measure(raw);
  const BoardInputs inputs = measured(wiring, raw, core.outputs(), core.last_inputs());
  port.apply(pins_for(wiring, core.step(inputs)));
  core.write_telemetry(packet);
  port.send(packet);
}

}  // namespace hedgehog::board

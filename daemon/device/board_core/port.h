// SPDX-License-Identifier: MIT
// Between the rules and the pins: what a microcontroller's converters, timers and pins say and want
// on a board with three Pololu G2 18v17 drivers, a 10 k NTC and a four-wire fan. Whole numbers,
// freestanding, tested on the host and on a Cortex-M0: a firmware adds only the registers.
//
// Pins, for each of the three drivers (wiring and safety notes: README.md beside this file):
//   PWM  out  one timer channel, 20 kHz or more; low = brake
//   DIR  out  low = current A -> B, counted as positive here
//   SLP  out  one for all three, pulled DOWN by a resistor; high = awake
//   FLT  in   open drain, pulled up; low = fault
//   CS   in   converter, sampled in the middle of the PWM's on-time
// and once: the supply through a divider (converter), the NTC against a pull-up (converter), the
// fan's PWM (25 kHz, not inverted) and its tach (open collector, 2 pulses a turn), the supply
// switch.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "daemon/device/board_core/board_core.h"

namespace hedgehog::board {

/// What differs between boards. Millivolts and ohms; the converter's numbers are 0..adc_full.
struct Wiring {
  uint16_t adc_full = 4095;
  /// At adc_full; the NTC's pull-up goes to the same voltage, so it drops out of the temperature.
  uint16_t adc_reference_mv = 3300;
  /// CS: volts an ampere and at no current. 18v17: about 20 mV/A and 50 mV; to be calibrated, for
  /// the offset alone is 2.5 A.
  uint16_t cs_mv_per_a = 20;
  uint16_t cs_offset_mv[kWindings] = {50, 50, 50};
  /// A shunt in the supply line, millivolts an ampere; 0: there is none. CS is dead while the
  /// bridges sleep, so without this shunt a bridge that is stuck is not seen, and the supply switch
  /// is of no use.
  uint16_t shunt_mv_per_a = 0;
  /// supply = pin x (upper + lower) / lower.
  uint16_t supply_upper_ohm = 47000;
  uint16_t supply_lower_ohm = 4700;
  /// The NTC is 10 k at 25 C with B = 3950 K, from the pin to ground.
  uint16_t ntc_pull_up_ohm = 10000;
  /// The PWM timer counts 0..pwm_top.
  uint16_t pwm_top = 2399;
  uint16_t fan_top = 1919;
};

/// One millisecond of measurements, as the peripherals give them.
struct RawInputs {
  /// Of the on-time that ended last; ignored for a bridge that was not driven.
  uint16_t cs_adc[kWindings] = {};
  uint16_t supply_adc = 0;
  uint16_t shunt_adc = 0;
  uint16_t ntc_adc = 0;
  /// `ntc_adc` is a new conversion.
  bool ntc_converted = false;
  /// Bit k: FLT of driver k is low.
  uint8_t faults_low = 0;
  /// Microseconds between the last two falling edges of the tach; 0: none for 250 ms.
  uint32_t tach_period_us = 0;
};

/// What the pins shall be until the next millisecond.
struct PinOutputs {
  /// Compare values, 0..pwm_top.
  uint16_t pwm[kWindings] = {};
  /// DIR is high.
  bool reverse[kWindings] = {};
  bool awake = false;
  bool supply_switch_closed = true;
  uint16_t fan_pwm = 0;
};

/// The safe pins: what reset must leave, what a fault handler sets by itself.
constexpr PinOutputs safe_pins(const Wiring& wiring) noexcept {
  PinOutputs pins;
  pins.fan_pwm = wiring.fan_top;
  return pins;
}

/// What the rules want to know. `applied` is what `BoardCore::step` returned the last time: CS has
/// no sign, so the direction of the bridge is taken, and says nothing while the bridge brakes or
/// sleeps, so the current then counts as 0; what the shunt sees while they sleep is put down to the
/// first winding.
BoardInputs measured(const Wiring& wiring, const RawInputs& raw,
                     const BoardOutputs& applied) noexcept;

PinOutputs pins_for(const Wiring& wiring, const BoardOutputs& outputs) noexcept;

/// Hundredths of a degree; the NTC at `adc` of `adc_full` under a pull-up of `pull_up_ohm`. Within
/// 0.2 K from 0 to 100 C, 0.6 K from -40 to 125 C; clamped beyond.
int16_t ntc_cc(uint16_t adc, uint16_t adc_full, uint16_t pull_up_ohm) noexcept;

/// The millisecond of a firmware. `Port` has:
///   size_t receive(uint8_t* packet, size_t room)   the next packet of the host, 0: none
///   void   measure(RawInputs& raw)
///   void   apply(const PinOutputs& pins)
///   void   send(const uint8_t* frame)              64 bytes; dropped if the last is still waiting
/// Call it from the main loop on a 1 kHz tick, and feed the hardware watchdog (20 ms or less) there
/// and nowhere else: then a loop that hangs is a reset, and reset is SLP low.
template <class Port>
void board_millisecond(BoardCore& core, const Wiring& wiring, Port& port) noexcept {
  // One byte more than a frame, so that a longer packet is seen to be one.
  uint8_t packet[kFrameSize + 1];
  // A host sends two a millisecond; a flood may not keep the board from its rules.
  for (int i = 0; i < 4; ++i) {
    const size_t length = port.receive(packet, sizeof(packet));
    if (length == 0) break;
    core.receive(packet, length);
  }
  RawInputs raw;
  port.measure(raw);
  const BoardInputs inputs = measured(wiring, raw, core.outputs());
  port.apply(pins_for(wiring, core.step(inputs)));
  core.write_telemetry(packet);
  port.send(packet);
}

}  // namespace hedgehog::board

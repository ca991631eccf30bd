// SPDX-License-Identifier: MIT
#include "daemon/device/board_core/port.h"

namespace hedgehog::board {
namespace {

// 4096 log2(R / 1 ohm) of the NTC from -40 to 125 C in steps of 5 K: R = 10 k exp(B (1/T - 1/T25)),
// B = 3950 K.
constexpr uint32_t kNtc[] = {76252, 74151, 72135, 70201, 68343, 66557, 64839, 63185, 61592,
                             60056, 58574, 57143, 55762, 54426, 53135, 51886, 50676, 49505,
                             48370, 47269, 46202, 45166, 44160, 43183, 42234, 41311, 40414,
                             39541, 38691, 37864, 37059, 36274, 35509, 34763};
constexpr int kNtcSteps = sizeof(kNtc) / sizeof(kNtc[0]);
constexpr int32_t kNtcFirstCc = -4000;
constexpr int32_t kNtcStepCc = 500;

/// 4096 log2(value), by squaring the mantissa bit by bit. REQUIRES: value > 0.
uint32_t log2_q12(uint32_t value) noexcept {
  uint32_t exponent = 0;
  for (uint32_t rest = value; rest > 1; rest >>= 1) ++exponent;
  // 1..2 with 15 fractional bits
  uint32_t mantissa = exponent > 15 ? value >> (exponent - 15) : value << (15 - exponent);
  uint32_t fraction = 0;
  for (int bit = 0; bit < 12; ++bit) {
    mantissa = (mantissa * mantissa) >> 15;
    fraction <<= 1;
    if (mantissa >= 0x10000u) {
      mantissa >>= 1;
      fraction |= 1;
    }
  }
  return (exponent << 12) | fraction;
}

/// On a Cortex-M0 a 64-bit division takes many times as long as a 32-bit one, which suffices for
/// nearly every reading.
uint32_t quotient(uint64_t dividend, uint32_t divisor) noexcept {
  if (dividend <= UINT32_MAX) return static_cast<uint32_t>(dividend) / divisor;
  return static_cast<uint32_t>(dividend / divisor);
}

/// Sixteenths of a millivolt: a whole millivolt would be 50 mA at CS.
uint32_t sixteenths_mv(const Wiring& wiring, uint16_t adc) noexcept {
  const uint16_t read = adc < wiring.adc_full ? adc : wiring.adc_full;
  return quotient(uint64_t{read} * wiring.adc_reference_mv * 16u, wiring.adc_full);
}

int32_t microvolts(const Wiring& wiring, uint16_t adc) noexcept {
  return static_cast<int32_t>(sixteenths_mv(wiring, adc) * 125u / 2u);
}

int16_t saturated(int32_t value) noexcept {
  if (value > INT16_MAX) return INT16_MAX;
  return static_cast<int16_t>(value < -INT16_MAX ? -INT16_MAX : value);
}

/// The current that corresponds to `uv` above or below `zero_uv`, mA.
int16_t milliamperes(int32_t uv, int32_t zero_uv, uint32_t uv_per_a) noexcept {
  if (uv_per_a < 10) return 0;
  return saturated((uv - zero_uv) * 100 / static_cast<int32_t>(uv_per_a / 10));
}

uint16_t magnitude(int16_t value) noexcept {
  const int32_t wide = value;
  const int32_t positive = wide < 0 ? -wide : wide;
  return static_cast<uint16_t>(positive > INT16_MAX ? INT16_MAX : positive);
}

struct WindingCurrent {
  int16_t ma = 0;
  bool measured = false;
};

WindingCurrent by_driver_cs(int16_t shown_ma, int16_t duty_q15, bool awake) noexcept {
  if (!awake) return {};
  const uint16_t driven = magnitude(duty_q15);
  int16_t min_ma = kOpposedMa;
  if (driven == 0)
    min_ma = kUndrivenMa;
  else if (driven < static_cast<uint16_t>(kMinSampledDutyQ15))
    min_ma = kShortlyDrivenMa;
  if (shown_ma < min_ma) return {};
  const int16_t ma = shown_ma < 0 ? int16_t{0} : shown_ma;
  return {duty_q15 < 0 ? static_cast<int16_t>(-ma) : ma, true};
}

}  // namespace

int16_t ntc_cc(uint16_t adc, uint16_t adc_full, uint16_t pull_up_ohm) noexcept {
  if (adc >= adc_full) return static_cast<int16_t>(kNtcFirstCc);
  // In eighths of an ohm, because a hot NTC has only few ohms.
  const uint32_t eighths = quotient(uint64_t{8} * pull_up_ohm * adc, uint32_t{adc_full} - adc);
  const uint32_t level = log2_q12(eighths < 8 ? 8 : eighths) - (3u << 12);
  if (level >= kNtc[0]) return static_cast<int16_t>(kNtcFirstCc);
  for (int i = 1; i < kNtcSteps; ++i) {
    if (level < kNtc[i]) continue;
    const uint32_t above = kNtc[i - 1] - level;
    const uint32_t step = kNtc[i - 1] - kNtc[i];
    return static_cast<int16_t>(kNtcFirstCc + kNtcStepCc * (i - 1) +
                                static_cast<int32_t>(uint32_t{kNtcStepCc} * above / step));
  }
  return static_cast<int16_t>(kNtcFirstCc + kNtcStepCc * (kNtcSteps - 1));
}

BoardInputs measured(const Wiring& wiring, const RawInputs& raw, const BoardOutputs& applied,
                     const BoardInputs* last) noexcept {
  BoardInputs inputs;
  inputs.currents_measured = 0;
  inputs.currents_in_line = wiring.current_sense == CurrentSense::kInLine;
  for (int k = 0; k < kWindings; ++k) {
    const int16_t shown_ma = milliamperes(microvolts(wiring, raw.current_adc[k]),
                                          wiring.current_zero_uv[k], wiring.current_uv_per_a[k]);
    const WindingCurrent current = wiring.current_sense == CurrentSense::kInLine
                                       ? WindingCurrent{shown_ma, true}
                                       : by_driver_cs(shown_ma, applied.duty_q15[k], applied.awake);
    inputs.current_ma[k] = current.ma;
    const auto bit = static_cast<uint8_t>(1u << k);
    if (!current.measured) continue;
    inputs.currents_measured |= bit;
    const int32_t early_us = wiring.converted_before_us[k];
    if (early_us != 0 && last != nullptr && (last->currents_measured & bit) != 0) {
      const int32_t change_ma = int32_t{current.ma} - last->current_ma[k];
      inputs.current_ma[k] = saturated(current.ma + change_ma * early_us / (1000 - early_us));
    }
  }
  inputs.supply_current_measured = wiring.shunt_uv_per_a != 0;
  inputs.supply_ma =
      magnitude(milliamperes(microvolts(wiring, raw.shunt_adc), 0, wiring.shunt_uv_per_a));
  const uint64_t supply = uint64_t{sixteenths_mv(wiring, raw.supply_adc)} *
                          (uint32_t{wiring.supply_upper_ohm} + wiring.supply_lower_ohm) /
                          (wiring.supply_lower_ohm == 0 ? 1u : wiring.supply_lower_ohm) / 16u;
  inputs.supply_mv = static_cast<uint16_t>(supply > UINT16_MAX ? uint64_t{UINT16_MAX} : supply);
  inputs.thermistors = wiring.thermistors;
  for (int k = 0; k < wiring.thermistors && k < kWindings; ++k) {
    ThermistorInput& thermistor = inputs.thermistor[k];
    // 1 % from either rail: beyond -60 C and 185 C.
    thermistor.open = raw.ntc_adc[k] > wiring.adc_full - wiring.adc_full / 100;
    thermistor.shorted = raw.ntc_adc[k] < wiring.adc_full / 100;
    thermistor.cc = ntc_cc(raw.ntc_adc[k], wiring.adc_full, wiring.ntc_pull_up_ohm);
  }
  inputs.thermistors_converted = raw.ntc_converted;
  inputs.bridge_faults = static_cast<uint8_t>(raw.faults_low & 7u);
  if (raw.tach_period_us != 0) {
    const uint32_t rpm = 30'000'000u / raw.tach_period_us;
    inputs.fan_rpm = static_cast<uint16_t>(rpm > UINT16_MAX ? uint32_t{UINT16_MAX} : rpm);
  }
  return inputs;
}

PinOutputs pins_for(const Wiring& wiring, const BoardOutputs& outputs) noexcept {
  PinOutputs pins;
  pins.awake = outputs.awake;
  pins.supply_switch_closed = outputs.supply_switch_closed;
  pins.fan_pwm = static_cast<uint16_t>(uint32_t{wiring.fan_top} * outputs.fan / 255u);
  for (int k = 0; k < kWindings; ++k) {
    const int16_t duty = outputs.awake ? outputs.duty_q15[k] : int16_t{0};
    pins.pwm[k] = static_cast<uint16_t>(uint32_t{wiring.pwm_top} * magnitude(duty) / INT16_MAX);
    pins.reverse[k] = duty < 0;
  }
  return pins;
}

}  // namespace hedgehog::board

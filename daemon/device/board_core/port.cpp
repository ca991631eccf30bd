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
  // 1..2 in 15 bits behind the point
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

uint32_t millivolts(const Wiring& wiring, uint16_t adc) noexcept {
  return uint32_t{adc} * wiring.adc_reference_mv / wiring.adc_full;
}

/// What more than `offset_mv` stands for, mA, at most `INT16_MAX`.
int16_t milliamperes(uint32_t mv, uint16_t offset_mv, uint16_t mv_per_a) noexcept {
  if (mv <= offset_mv || mv_per_a == 0) return 0;
  const uint32_t ma = (mv - offset_mv) * 1000u / mv_per_a;
  return static_cast<int16_t>(ma > INT16_MAX ? uint32_t{INT16_MAX} : ma);
}

uint16_t magnitude(int16_t value) noexcept {
  const int32_t wide = value;
  const int32_t positive = wide < 0 ? -wide : wide;
  return static_cast<uint16_t>(positive > INT16_MAX ? INT16_MAX : positive);
}

}  // namespace

int16_t ntc_cc(uint16_t adc, uint16_t adc_full, uint16_t pull_up_ohm) noexcept {
  if (adc == 0) adc = 1;
  if (adc >= adc_full) return static_cast<int16_t>(kNtcFirstCc);
  // In eighths of an ohm, for a hot NTC has few.
  const uint32_t eighths =
      static_cast<uint32_t>(uint64_t{8} * pull_up_ohm * adc / (uint32_t{adc_full} - adc));
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

BoardInputs measured(const Wiring& wiring, const RawInputs& raw,
                     const BoardOutputs& applied) noexcept {
  BoardInputs inputs;
  for (int k = 0; k < kWindings; ++k) {
    const int16_t duty = applied.awake ? applied.duty_q15[k] : int16_t{0};
    if (duty == 0) continue;
    const int16_t ma =
        milliamperes(millivolts(wiring, raw.cs_adc[k]), wiring.cs_offset_mv[k], wiring.cs_mv_per_a);
    inputs.current_ma[k] = duty < 0 ? static_cast<int16_t>(-ma) : ma;
  }
  if (!applied.awake) {
    inputs.current_ma[0] =
        milliamperes(millivolts(wiring, raw.shunt_adc), 0, wiring.shunt_mv_per_a);
  }
  const uint32_t supply = millivolts(wiring, raw.supply_adc) *
                          (uint32_t{wiring.supply_upper_ohm} + wiring.supply_lower_ohm) /
                          (wiring.supply_lower_ohm == 0 ? 1u : wiring.supply_lower_ohm);
  inputs.supply_mv = static_cast<uint16_t>(supply > UINT16_MAX ? uint32_t{UINT16_MAX} : supply);
  // 1 % from either rail: beyond -60 C and 185 C.
  inputs.sensor_open = raw.ntc_adc > wiring.adc_full - wiring.adc_full / 100;
  inputs.sensor_short = raw.ntc_adc < wiring.adc_full / 100;
  inputs.sensor_cc = ntc_cc(raw.ntc_adc, wiring.adc_full, wiring.ntc_pull_up_ohm);
  inputs.sensor_converted = raw.ntc_converted;
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

// SPDX-License-Identifier: MIT
// What the firmware takes its board for: the reference board with the Pico's timers and the figures
// of calibration.h.
#pragma once

#include <stdint.h>

#include "daemon/device/board_core/port.h"
#include "firmware/calibration.h"

namespace hedgehog::firmware {

/// 125 MHz / 6250 = 20 kHz for the bridges, up to the top and back; / 5000 = 25 kHz for the fan.
inline constexpr uint32_t kPwmPeriod = 6250;
inline constexpr uint16_t kPwmTop = kPwmPeriod / 2 - 1;
inline constexpr uint16_t kFanTop = 4999;

constexpr board::Wiring pico_wiring() noexcept {
  board::Wiring wiring = board::reference_wiring();
  wiring.pwm_top = kPwmTop;
  wiring.fan_top = kFanTop;
  for (int k = 0; k < board::kWindings; ++k) {
    wiring.current_zero_uv[k] = calibration::kCurrentZeroUv[k];
    wiring.current_uv_per_a[k] = calibration::kCurrentUvPerA[k];
  }
  wiring.shunt_uv_per_a = calibration::kShuntUvPerA;
  return wiring;
}

/// Farther from the design a figure is an error in reading or entering it, or a wrong part: the
/// tolerances of the parts (firmware/board/figures.md) are within these.
inline constexpr int32_t kMaxZeroDeviationUv = 8'000;
inline constexpr int64_t kMaxScaleDeviationPercent = 3;

constexpr bool is_near(int64_t value, int64_t design, int64_t deviation) noexcept {
  return value >= design - deviation && value <= design + deviation;
}
constexpr bool is_near_scale(int64_t value, int64_t design) noexcept {
  return is_near(100 * value, 100 * design, kMaxScaleDeviationPercent * design);
}
constexpr bool zeros_are_plausible(const board::Wiring& own, const board::Wiring& design) noexcept {
  for (int k = 0; k < board::kWindings; ++k)
    if (!is_near(own.current_zero_uv[k], design.current_zero_uv[k], kMaxZeroDeviationUv))
      return false;
  return true;
}
constexpr bool scales_are_plausible(const board::Wiring& own,
                                    const board::Wiring& design) noexcept {
  for (int k = 0; k < board::kWindings; ++k)
    if (!is_near_scale(own.current_uv_per_a[k], design.current_uv_per_a[k])) return false;
  return is_near_scale(own.shunt_uv_per_a, design.shunt_uv_per_a);
}
static_assert(sizeof(calibration::kCurrentZeroUv) == sizeof(board::Wiring::current_zero_uv),
              "calibration.h: kCurrentZeroUv has three figures, of windings x, y and z");
static_assert(sizeof(calibration::kCurrentUvPerA) == sizeof(board::Wiring::current_uv_per_a),
              "calibration.h: kCurrentUvPerA has three figures, of windings x, y and z");
static_assert(zeros_are_plausible(pico_wiring(), board::reference_wiring()),
              "calibration.h: a zero is more than 8 mV from 1.650 V: repeat step 6 of bring-up.md");
static_assert(scales_are_plausible(pico_wiring(), board::reference_wiring()),
              "calibration.h: a scale is more than 3 % from the design: repeat step 6 of "
              "bring-up.md");

static_assert(board::reference_wiring().converted_before_us[0] == 2 * kPwmPeriod / 125,
              "the windings are converted in three periods of the PWM one after the other");

}  // namespace hedgehog::firmware

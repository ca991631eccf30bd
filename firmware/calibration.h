// SPDX-License-Identifier: MIT
// The figures of one board. Those here are the design's, for a board that has not been measured
// yet. A board of your own: copy this file, enter the figures of firmware/board/bring-up.md,
// step 6, and
//
//   make firmware-calibrated CALIBRATION=my-board.h
//
// Windings in the order x, y, z: U2, U3, U4. What no part within its tolerance has is an error of
// the compiler (pico_wiring.h).
#pragma once

#include <stdint.h>

namespace hedgehog::firmware::calibration {

/// Step 6, by telemetry: what is read without a current.
inline constexpr int32_t kCurrentZeroUv[] = {1'650'000, 1'650'000, 1'650'000};
/// Step 6, by telemetry: what is read of 5.00 A each way.
inline constexpr uint32_t kCurrentUvPerA[] = {50'000, 50'000, 50'000};
/// Step 6, by a meter at the output of U5: its rise with 5.00 A, over 5, times 3.300 / AVDD.
inline constexpr uint32_t kShuntUvPerA = 100'000;

}  // namespace hedgehog::firmware::calibration

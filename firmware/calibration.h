// SPDX-License-Identifier: MIT
// The figures of one board. Those here are the design's, for a board that has not been measured
// yet. A board of your own: copy this file, enter what firmware/board/bring-up.md had you write
// down, and
//
//   make firmware-calibrated CALIBRATION=my-board.h
//
// Windings in the order x, y, z: U2, U3, U4. What no part within its tolerance has is an error of
// the compiler (pico_wiring.h).
#pragma once

#include <stdint.h>

namespace hedgehog::firmware::calibration {

/// Step 2: the amplifiers' outputs at no current, times 3.300 / AVDD.
inline constexpr int32_t kCurrentZeroUv[] = {1'650'000, 1'650'000, 1'650'000};
/// Step 5: their rise with 5.00 A, over 5, times 3.300 / AVDD.
inline constexpr uint32_t kCurrentUvPerA[] = {50'000, 50'000, 50'000};
/// Step 5: the same of U5.
inline constexpr uint32_t kShuntUvPerA = 100'000;

}  // namespace hedgehog::firmware::calibration

// SPDX-License-Identifier: MIT
// The calibration values of a board whose parts are near the ends of their tolerances, as its
// builder would enter them: calibration.test.mjs simulates electronics with these deviations.
#pragma once

#include <stdint.h>

namespace hedgehog::firmware::calibration {

inline constexpr int32_t kCurrentZeroUv[] = {1'643'500, 1'656'000, 1'652'500};
inline constexpr uint32_t kCurrentUvPerA[] = {50'800, 49'300, 49'200};
inline constexpr uint32_t kShuntUvPerA = 101'500;

}  // namespace hedgehog::firmware::calibration

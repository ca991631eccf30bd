// SPDX-License-Identifier: MIT
// The non-finite numbers.
#pragma once

#include <limits>

namespace hedgehog::model {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "clients/design/input/design.h"

namespace hedgehog::design {

/// Counts, gaps, classes and positions of all magnets as JSON, for `array` and `export`.
std::string array_json(const Design& design, const model::Arrangement& array);

}  // namespace hedgehog::design

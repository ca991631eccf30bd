// SPDX-License-Identifier: MIT
// A design as a file, so that no verb needs its flags again:
//
//     { "array": "tkD-86", "magnet": "8x10", "shield": "4x10", "sphere_mm": 35 }
//
// What is left out is as in the ball of the thesis.
#pragma once

#include <string>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"

namespace hedgehog::design {

/// The complaint (65, or 66 when there is no such file) names the file and the key.
Result<Design> load_design(const std::string& path);
Result<Design> parse_design(const std::string& text, const std::string& name);

/// Every key, those of a search too: nothing is left to defaults that may change.
std::string design_text(const Design& design);

/// Complains when a design file stands at `path`: other things are not written over it
/// (`--output best.json` is easily typed for `best.json --output`).
Result<void> spare_design(const std::string& path);

}  // namespace hedgehog::design

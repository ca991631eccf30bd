// SPDX-License-Identifier: MIT
// A design as a file, as an alternative to the flags of the verbs:
//
//     { "array": "tkD-86", "magnet": "8x10", "shield": "4x10", "sphere_mm": 35 }
//
// Missing keys are as in the ball of the thesis.
#pragma once

#include <string>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"

namespace hedgehog::design {

/// The error (65, or 66 if there is no such file) contains the file and the key.
Result<Design> load_design(const std::string& path);
Result<Design> parse_design(const std::string& text, const std::string& name);

/// Writes every key, including the coil force of a search, independent of defaults that may change.
std::string design_text(const Design& design);

/// An error if `path` is a design file, which must not be overwritten by other output (`--output
/// best.json` is easily typed for `best.json --output`).
Result<void> protect_design(const std::string& path);

}  // namespace hedgehog::design

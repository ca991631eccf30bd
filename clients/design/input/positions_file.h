// SPDX-License-Identifier: MIT
// Positions of magnets as CSV, one magnet per line:
//
//     kind,id,x_mm,y_mm,z_mm
//     pin,0,0,0,35
//     shield,0,12.3,4.1,32.5
//
// Columns read: kind (pin or shield), x, y, z (or x_mm, ...) in any order, of any length since only
// the direction is used; id, if present, is kept. Other columns are ignored.
#pragma once

#include <string>

#include "clients/common/problem.h"
#include "model/magnets/arrangement.h"
#include "model/magnets/magnet_array.h"

namespace hedgehog::design {

/// The error contains file and line.
Result<model::Arrangement> read_positions(const std::string& path);
Result<model::Arrangement> parse_positions(const std::string& text, const std::string& name);

/// In the format of `read_positions`, with additional columns for angles and sizes.
std::string positions_csv(const model::Arrangement& arrangement, const model::ArraySizes& sizes);

}  // namespace hedgehog::design

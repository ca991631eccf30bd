// SPDX-License-Identifier: MIT
// The places of magnets as CSV, one magnet a line:
//
//     kind,id,x_mm,y_mm,z_mm
//     pin,0,0,0,35
//     shield,0,12.3,4.1,32.5
//
// Read: the columns kind (pin or shield), x, y, z (or x_mm, ...) in any order, of any length since
// only the direction counts; id, when there, is kept. Others are passed over.
#pragma once

#include <string>

#include "clients/common/problem.h"
#include "model/magnets/arrangement.h"
#include "model/magnets/magnet_array.h"

namespace hedgehog::design {

/// The complaint names file and line.
Result<model::Arrangement> read_positions(const std::string& path);
Result<model::Arrangement> parse_positions(const std::string& text, const std::string& name);

/// As `read_positions` reads it, with angles and sizes beside the places.
std::string positions_csv(const model::Arrangement& arrangement, const model::ArraySizes& sizes);

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
// The keys of a device file for the magnets of the ball and their positions.
#pragma once

#include <string>
#include <vector>

#include "base/keys/file_error.h"
#include "base/keys/key.h"
#include "base/keys/key_tree.h"
#include "model/device_model.h"

namespace hedgehog::config {

std::vector<keys::Key<model::DeviceModel>> geometry_keys();

/// Geometries already validated.
using KnownGeometries = std::vector<model::BallGeometry>;

/// Adds an error for an impossible geometry, at the key concerned. Computes its arrangement
/// (GP(8,0): a second), unless it is that of the thesis or in `possible`.
void check_geometry(const model::BallGeometry& geometry, const KnownGeometries& possible,
                    const keys::Origins& origins, const std::string& file,
                    keys::FileErrors& errors);

}  // namespace hedgehog::config

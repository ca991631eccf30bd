// SPDX-License-Identifier: MIT
// The keys of a device file that say which magnets the ball has and where.
#pragma once

#include <string>
#include <vector>

#include "daemon/config/config_error.h"
#include "daemon/config/keys/key.h"
#include "daemon/config/keys/key_tree.h"
#include "model/device_model.h"

namespace hedgehog::config {

std::vector<Key<model::DeviceModel>> geometry_keys();

/// Geometries that have been found possible.
using KnownGeometries = std::vector<model::BallGeometry>;

/// Adds to `errors` why there can be no such ball, about the key that is wrong. Computes its
/// arrangement (GP(8,0): a second), unless it is that of the thesis or among `possible`.
void check_geometry(const model::BallGeometry& geometry, const KnownGeometries& possible,
                    const Origins& origins, const std::string& file, ConfigErrors& errors);

}  // namespace hedgehog::config

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

/// Adds to `errors` why there can be no such ball; computes its arrangement, unless it is that of
/// the thesis.
void check_geometry(const model::BallGeometry& geometry, const Origins& origins,
                    const std::string& file, ConfigErrors& errors);

}  // namespace hedgehog::config

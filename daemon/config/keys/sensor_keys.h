// SPDX-License-Identifier: MIT
// The keys "imu" and "thermometer" of hedgehogd.json, documented there.
#pragma once

#include <vector>

#include "base/keys/file_error.h"
#include "base/keys/key_tree.h"
#include "daemon/config/keys/config_keys.h"

namespace hedgehog::config {

void add_sensor_keys(std::vector<keys::Key<Draft>>& keys);

/// Checks that need the whole configuration: resolves "auto" and detects contradictions.
void resolve_sensors(Draft& draft, const keys::Origins& origins, const std::string& file,
                     keys::FileErrors& errors);

}  // namespace hedgehog::config

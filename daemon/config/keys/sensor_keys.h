// SPDX-License-Identifier: MIT
// The keys "imu" and "thermometer" of hedgehogd.json, documented there.
#pragma once

#include <vector>

#include "daemon/config/config_error.h"
#include "daemon/config/keys/config_keys.h"
#include "daemon/config/keys/key_tree.h"

namespace hedgehog::config {

void add_sensor_keys(std::vector<Key<Draft>>& keys);

/// Checks that need the whole configuration: resolves "auto" and detects contradictions.
void resolve_sensors(Draft& draft, const Origins& origins, const std::string& file,
                     ConfigErrors& errors);

}  // namespace hedgehog::config

// SPDX-License-Identifier: MIT
// The keys of hedgehogd.json, documented in config/hedgehogd.json.
#pragma once

#include <optional>
#include <vector>

#include "base/keys/key.h"
#include "daemon/config/config.h"
#include "daemon/config/keys/limit_keys.h"

namespace hedgehog::config {

/// A Config being read, with the values that can be resolved only after all files are read.
struct Draft {
  Config config;
  LimitOverrides limits;
  /// nullopt: "auto".
  std::optional<ImuSource> imu;
};

/// All keys, in the order of the documented file.
const std::vector<keys::Key<Draft>>& config_keys();

}  // namespace hedgehog::config

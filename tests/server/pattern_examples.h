// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/server/server_rig.h"

namespace hedgehog::server {

/// 300 ms at half strength to the left, then 300 ms of silence.
inline const Json kLeft = Json::parse(R"([{"t_ms":0,"direction":"left","level":0.5,"ease":"step"},
                                   {"t_ms":300,"level":0,"ease":"step"},{"t_ms":600,"level":0}])");

inline Json knock(const std::string& name = "acme/knock") {
  return {{"name", name}, {"keyframes", kLeft}};
}

}  // namespace hedgehog::server

// SPDX-License-Identifier: MIT
#include "daemon/server/session/start_id.h"

#include <fmt/format.h>

#include <random>

namespace hedgehog::server {

std::string random_start_id() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

}  // namespace hedgehog::server

// SPDX-License-Identifier: MIT
// Behaviour of the daemon that contradicts its documentation.
#pragma once

#include <stdexcept>

namespace hedgehog::soak {

struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace hedgehog::soak

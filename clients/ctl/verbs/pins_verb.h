// SPDX-License-Identifier: MIT
// The verb that shows every pin: force and extension. Returns the exit code.
#pragma once

#include <cstdint>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct PinsOptions {
  /// Again and again: a picture on a terminal of 80x22, else a line each.
  bool live = false;
  /// With `live`: ends after so many; 0: never.
  std::int64_t count = 0;
};
int run_pins(Session& session, const PinsOptions& options);

}  // namespace hedgehog::client

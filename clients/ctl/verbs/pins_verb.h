// SPDX-License-Identifier: MIT
// The verb that prints force and extension of every pin. Returns the exit code.
#pragma once

#include <cstdint>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct PinsOptions {
  /// Repeatedly: a picture on a terminal of 80x22, otherwise lines.
  bool live = false;
  /// With `live`: ends after this many lines; 0: never.
  std::int64_t count = 0;
};
int run_pins(Session& session, const PinsOptions& options);

}  // namespace hedgehog::client

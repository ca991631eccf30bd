// SPDX-License-Identifier: MIT
// The manual part of a calibration: which side each winding pushes.
#pragma once

#include "clients/ctl/calibrate/calibration.h"
#include "clients/ctl/calibrate/winding_bench.h"

namespace hedgehog::client {

/// Asks on stdout and stdin, push by push, until each winding has an axis of its own. Blocking.
/// Errors: a push fails, end of input, or Ctrl-C.
Outcome<PushedSides> prompt_sides(WindingBench& bench, double push_a);

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// The board core's rules as a deterministic program whose output must be identical, line by line,
// on the host and on a Cortex-M0. Freestanding, like the core.
#pragma once

#include <stdint.h>

namespace hedgehog::firmware {

/// Called with one line at a time, without its end.
using Print = void (*)(const char* line);

/// All vectors; true when every expectation in them held.
bool run_vectors(Print print) noexcept;

}  // namespace hedgehog::firmware

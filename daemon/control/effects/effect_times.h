// SPDX-License-Identifier: MIT
// Time stamps of an effect from its request to the bus. Trivially copyable.
#pragma once

#include <cstdint>

namespace hedgehog::control {

/// CLOCK_MONOTONIC.
struct EffectTimes {
  std::uint64_t seq = 0;         // of the command that starts or updates the effect
  std::int64_t received_ns = 0;  // io has read the request from the socket
  std::int64_t queued_ns = 0;    // the command was queued for the control thread
  std::int64_t applied_ns = 0;   // the tick that applied it has passed its set-point to the link
  std::int64_t written_ns = 0;   // the first frame with that or a later set-point was written
};

}  // namespace hedgehog::control

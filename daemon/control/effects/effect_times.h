// SPDX-License-Identifier: MIT
// Time stamps of an effect from its request to the bus. Trivially copyable.
#pragma once

#include <cstdint>

namespace hedgehog::control {

/// CLOCK_MONOTONIC, ns.
struct EffectTimes {
  /// Of the command that starts or updates the effect.
  std::uint64_t seq = 0;
  /// io has read the request from the socket.
  std::int64_t received_ns = 0;
  /// The command was queued for the control thread.
  std::int64_t queued_ns = 0;
  /// The tick that applied the command has passed its set-point to the link.
  std::int64_t applied_ns = 0;
  /// The first frame with that set-point, or with a later one, was written to the board.
  std::int64_t written_ns = 0;
};

}  // namespace hedgehog::control

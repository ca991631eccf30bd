// SPDX-License-Identifier: MIT
// How the device time of a simulated ball advances.
#pragma once

namespace hedgehog::control {

/// At each wake-up by `speed` ticks for each of `step_ms` milliseconds. Fewer wake-ups take less
/// processor time, and requests take effect, stops too, up to `step_ms` later.
struct Pace {
  static constexpr int kMaxSpeed = 100;
  /// Bounded by Heading::kFresh, and because leases have to be renewed between two steps.
  static constexpr int kMaxStepMs = 20;
  /// Events of that many ticks fit into the queue until io reads them.
  static constexpr int kMaxTicks = 100;

  int speed = 1;    ///< ticks per real millisecond
  int step_ms = 1;  ///< real time between two wake-ups, ms

  constexpr int ticks() const noexcept { return speed * step_ms; }
};

}  // namespace hedgehog::control

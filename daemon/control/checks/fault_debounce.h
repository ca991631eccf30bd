// SPDX-License-Identifier: MIT
// Fault debouncing by a leaky integrator: held time grows while the condition is true, else falls.
#pragma once

namespace hedgehog::control {

/// Real-time safe, trivially copyable.
class FaultDebounce {
 public:
  /// Advances by `dt_s`. True when `wrong` has held for `hold_s`, or longer if intermittent. Takes
  /// at least three steps, however long they are.
  bool step(bool wrong, double dt_s, double hold_s) noexcept;
  /// The condition held recently.
  bool pending() const noexcept { return held_s_ > 0.0; }
  void reset() noexcept { held_s_ = 0.0; }

 private:
  double held_s_ = 0.0;
};

}  // namespace hedgehog::control

// SPDX-License-Identifier: MIT
// The driver's inputs.
#pragma once

namespace hedgehog::racer {

struct Controls {
  double steer = 0.0;     // -1 left .. 1 right
  double throttle = 0.0;  // 0..1
  double brake = 0.0;     // 0..1; at a standstill it reverses
  friend bool operator==(const Controls&, const Controls&) = default;
};

}  // namespace hedgehog::racer

// SPDX-License-Identifier: MIT
// The built-in driver: follows the middle of the road at the speed that the bends allow, for demos
// and tests.
#pragma once

#include "clients/racer/game/controls.h"
#include "clients/racer/game/scene.h"
#include "clients/racer/game/track.h"

namespace hedgehog::racer {

/// Stateful; begin each race with a new one.
class Driver {
 public:
  /// REQUIRES: called once for each step of the race.
  Controls drive(const Scene& scene, const Track& track);

 private:
  int stuck_steps_ = 0;
  int reverse_steps_ = 0;
};

}  // namespace hedgehog::racer

// SPDX-License-Identifier: MIT
// Events of the car in one step of the race that can be felt. Directions are unit vectors in the
// car's frame: x front, y left, z up.
#pragma once

#include <variant>

#include "model/vec3.h"

namespace hedgehog::racer {

/// A collision of the car; reported once for each blow, not while it scrapes along.
struct Hit {
  model::Vec3
      direction{};  // from the middle of the car to where it was hit; a corner is 45 degrees
  double impulse_n_s = 0.0;  // Newton seconds; 800 = a change of the car's speed by 1 m/s
  friend bool operator==(const Hit&, const Hit&) = default;
};

/// The wheels touch the ground again after a flight.
struct Landing {
  double impulse_n_s = 0.0;  // absorbed by the ground
  friend bool operator==(const Landing&, const Landing&) = default;
};

/// The wheels slide. Reported in every step while it lasts.
struct Skid {
  double amount = 0.0;  // 0: full grip .. 1: no grip
  friend bool operator==(const Skid&, const Skid&) = default;
};

/// The car turns over or lies on its side or roof. Reported in every step while it lasts.
struct Tumble {
  model::Vec3 down{0, 0, -1};  // direction of the ground, in the car's frame
  friend bool operator==(const Tumble&, const Tumble&) = default;
};

struct LapDone {
  int lap = 1;
  double time_s = 0.0;
  friend bool operator==(const LapDone&, const LapDone&) = default;
};

/// The car was put back on the road, or the race starts again.
struct Reset {
  friend bool operator==(const Reset&, const Reset&) = default;
};

using RaceEvent = std::variant<Hit, Landing, Skid, Tumble, LapDone, Reset>;

}  // namespace hedgehog::racer

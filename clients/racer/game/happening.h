// SPDX-License-Identifier: MIT
// What the car goes through in one step of the race: all that a person could feel of it. Directions
// are unit vectors in the car's frame: x front, y left, z up.
#pragma once

#include <variant>

#include "model/vec3.h"

namespace hedgehog::racer {

/// The car ran into something or was run into; told once for each blow, not while it scrapes along.
struct Hit {
  model::Vec3
      direction{};  // from the middle of the car to where it was hit; a corner is 45 degrees
  double impulse_n_s = 0.0;  // Newton seconds; 800 = the car's speed changed by 1 m/s
  friend bool operator==(const Hit&, const Hit&) = default;
};

/// The wheels are back on the ground after a flight.
struct Landing {
  double impulse_n_s = 0.0;  // what the ground took up
  friend bool operator==(const Landing&, const Landing&) = default;
};

/// The wheels slide. Told in every step while it lasts.
struct Skid {
  double amount = 0.0;  // 0 grips .. 1 no grip at all
  friend bool operator==(const Skid&, const Skid&) = default;
};

/// The car turns over or lies on its side or roof. Told in every step while it lasts.
struct Tumble {
  model::Vec3 down{0, 0, -1};  // where the ground is, seen from the car
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

using Happening = std::variant<Hit, Landing, Skid, Tumble, LapDone, Reset>;

}  // namespace hedgehog::racer

// SPDX-License-Identifier: MIT
// Position and orientation of an object. Metres; x forward, y left, z up, as in the ball's
// protocol.
#pragma once

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::racer {

using model::Quaternion;
using model::Vec3;

struct Pose {
  Vec3 position{};
  Quaternion orientation{};  // body -> world
  friend bool operator==(const Pose&, const Pose&) = default;
};

}  // namespace hedgehog::racer

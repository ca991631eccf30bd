// SPDX-License-Identifier: MIT
// The ball of the thesis as described by a daemon.
#pragma once

#include "model/magnets/ball_geometry.h"
#include "protocol/values/description.h"

namespace hedgehog::client {

inline protocol::Description thesis_description() {
  protocol::Description description;
  description.arrangement = model::thesis_ball().array.arrangement;
  for (const model::Pin& pin : model::thesis_ball().array.pins)
    description.pins.push_back({pin.id, pin.position, pin.ring, 0.0});
  return description;
}

}  // namespace hedgehog::client

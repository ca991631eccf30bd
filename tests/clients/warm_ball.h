// SPDX-License-Identifier: MIT
// A ball in a person's hand, as described by its daemon: at 41 °C, after 40 s at 15 A.
#pragma once

#include <vector>

#include "clients/ctl/screen/ball.h"
#include "model/geometry/field.h"
#include "tests/clients/thesis_description.h"

namespace hedgehog::client {

inline std::vector<double> forces_of(const model::Vec3& demand_a) {
  std::vector<double> forces(model::thesis_ball().array.pins.size());
  model::pin_forces(model::thesis_ball().array, {demand_a}, 0.0126, forces);
  return forces;
}

inline Ball warm_ball() {
  Ball ball;
  ball.hello.version = "1.0.0";
  ball.description = thesis_description();
  ball.description.limits.derate_from_c = 60;
  ball.description.limits.trip_c = 70;
  ball.description.thermal.sensor_winding = 2;
  protocol::Status& status = ball.status;
  status.device = "ball-7";
  status.state = "armed";
  status.temperature_c = {.sensor = 41.2, .model = 41.6, .coils = {41.0, 41.6, 40.9}, .age_ms = 3};
  status.limit_a = 15;
  status.burst_s = 11.0;
  status.current_a = {0, 4.99, 0.12};
  status.duty = {0, 0.199, 0.005};
  status.field = {0, 0.9997, 0.024};
  status.force_n = 0.062;
  status.pin = 33;
  status.fan = {4310, 0.6};
  status.orientation =
      protocol::OrientationStatus{{0.994, -0.105, 0.035, 0}, {-0.069, -0.208, 0.976}, {}, 3};
  status.loop = {1000, 273'600'000, 0, {12, 61, 240}};
  status.pins.force_n = forces_of({0, 5, 0});
  protocol::EffectStatus circle;
  circle.effect = 412;
  circle.method = "effect.circle";
  circle.client = "Racer 1.2";
  circle.playing = true;
  circle.remaining_ms = 12'000;
  circle.current_a = 4.99;
  status.effects.push_back(circle);
  return ball;
}

/// After 40 s at 15 A.
inline Ball hot_ball() {
  Ball ball = warm_ball();
  ball.status.temperature_c = {
      .sensor = 38.3, .model = 66.1, .coils = {40.8, 66.1, 38.4}, .age_ms = 3};
  return ball;
}

}  // namespace hedgehog::client

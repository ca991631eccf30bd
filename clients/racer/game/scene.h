// SPDX-License-Identifier: MIT
// State of the race in one frame, for display.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "clients/racer/game/controls.h"
#include "clients/racer/game/pose.h"

namespace hedgehog::racer {

struct Wheel {
  Pose pose{};  // its middle; y is the axle
  bool contact = false;
  double skid = 0.0;  // 0: rolls .. 1: no grip
  friend bool operator==(const Wheel&, const Wheel&) = default;
};

struct Scene {
  double time_s = 0.0;  // since the start or the last reset
  Pose car{};           // its centre of mass, see car.h
  std::array<Wheel, 4> wheels{};
  double speed_mps = 0.0;   // along the car, negative backwards
  Controls controls{};      // in force
  int lap = 1;              // number of the present lap
  double lap_time_s = 0.0;  // since the player began to drive
  std::optional<double> last_lap_s{};
  std::optional<double> best_lap_s{};
  std::vector<Pose> obstacles{};  // in the order of Track::obstacles
  friend bool operator==(const Scene&, const Scene&) = default;
};

}  // namespace hedgehog::racer

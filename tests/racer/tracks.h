// SPDX-License-Identifier: MIT
// Small tracks, each for one kind of event, and a car that drives on them in simulated time.
#pragma once

#include <cmath>
#include <functional>
#include <variant>
#include <vector>

#include "clients/racer/game/race.h"
#include "model/magnets/arrangement.h"

namespace hedgehog::racer {

inline constexpr double kDegree = 3.14159265358979323846 / 180.0;

inline Vec3 towards(double azimuth_deg) {
  return {std::cos(azimuth_deg * kDegree), std::sin(azimuth_deg * kDegree), 0};
}

/// Only ground; the car is at the origin and faces along x.
inline Track open_ground() { return {}; }

/// A heavy ball flies towards the middle of the car, which is at rest.
inline Track ball_thrown_from(double azimuth_deg, double mass_kg, double speed_mps) {
  Track track = open_ground();
  const Vec3 from = towards(azimuth_deg);
  const Vec3 start = 5.0 * from + Vec3{0, 0, 1.1};
  track.obstacles.push_back(
      {Shape::kBall, {start, {}}, {0.35, 0.35, 0.35}, mass_kg, -speed_mps * from});
  return track;
}

template <class What>
struct At {
  double time_s = 0.0;
  What what{};
};

/// Drives for `seconds`; returns every event of the type `What`.
template <class What>
std::vector<At<What>> drive(Race& race, double seconds, const Controls& controls) {
  std::vector<At<What>> found;
  for (double end = race.scene().time_s + seconds; race.scene().time_s < end;) {
    race.step(controls);
    for (const RaceEvent& race_event : race.race_events())
      if (const auto* what = std::get_if<What>(&race_event))
        found.push_back({race.scene().time_s, *what});
  }
  return found;
}

}  // namespace hedgehog::racer

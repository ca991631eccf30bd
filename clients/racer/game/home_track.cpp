// SPDX-License-Identifier: MIT
#include <cmath>

#include "clients/racer/game/track.h"
#include "model/units.h"

namespace hedgehog::racer {

namespace {

/// A pose on the road: `along` metres after the start and `left` metres beside its middle, oriented
/// along the road.
Pose beside(const Track& track, double along, double left, double z) {
  const std::size_t count = track.centre.size();
  const double spacing = norm(track.centre[1] - track.centre[0]);
  const auto at = static_cast<std::size_t>(along / spacing) % count;
  const Vec3 ahead = unit_or(track.centre[(at + 1) % count] - track.centre[at], {1, 0, 0});
  const Vec3 place = track.centre[at] + left * cross({0, 0, 1}, ahead);
  return flat_pose(place.x, place.y, z, std::atan2(ahead.y, ahead.x) * model::kDegreesPerRadian);
}

void add_crate(Track& track, double along, double left, double mass_kg) {
  track.obstacles.push_back(
      {Shape::kBox, beside(track, along, left, 0.4), {0.4, 0.4, 0.4}, mass_kg});
}

void add_drum(Track& track, double along, double left, double mass_kg) {
  track.obstacles.push_back(
      {Shape::kDrum, beside(track, along, left, 0.5), {0.35, 0.35, 0.5}, mass_kg});
}

}  // namespace

Track home_track() {
  Track track = road_through({{-10, 0},
                              {20, 0},
                              {50, 0},
                              {75, 8},
                              {88, 28},
                              {80, 50},
                              {58, 58},
                              {38, 50},
                              {20, 40},
                              {0, 46},
                              {-14, 62},
                              {-36, 68},
                              {-58, 58},
                              {-66, 36},
                              {-58, 12},
                              {-38, 1}},
                             11.0);
  track.ramps.push_back({beside(track, 30, 0, 0), 6.0, 4.5, 0.9});
  // At the edges: lifts one side of the car, which may turn it over.
  track.ramps.push_back({beside(track, 64, -4.2, 0), 5.0, 1.4, 1.6});
  track.ramps.push_back({beside(track, 372, 4.2, 0), 5.0, 1.4, 1.6});
  track.patches.push_back({beside(track, 108, 0, 0), 7.5, 4.6, 0.1});
  add_drum(track, 166, -0.7, 40);
  add_crate(track, 188, 0.2, 30);
  track.patches.push_back({beside(track, 203, 0, 0), 7.5, 4.5, 0.06});
  track.obstacles.push_back({Shape::kBall, beside(track, 272, -1.1, 0.6), {0.6, 0.6, 0.6}, 25});
  track.patches.push_back({beside(track, 300, 0, 0), 6.5, 4.6, 0.3});
  add_crate(track, 358, 1.1, 100);
  return track;
}

}  // namespace hedgehog::racer

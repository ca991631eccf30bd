// SPDX-License-Identifier: MIT
// A track as data: for the race and for drawing on the page. Metres; the ground is z = 0.
#pragma once

#include <cstdint>
#include <vector>

#include "clients/racer/game/pose.h"

namespace hedgehog::racer {

/// A static box: walls consist of these.
struct Wall {
  Pose pose{};  // of its middle
  Vec3 half_size{};
};

enum class Shape : std::uint8_t { kBox, kDrum, kBall };

/// A movable object on the road.
struct Obstacle {
  Shape shape = Shape::kBox;
  Pose pose{};       // of its middle, at the start
  Vec3 half_size{};  // kDrum: standing upright, radius x; kBall: radius x
  double mass_kg = 50.0;
  Vec3 velocity_mps{};  // at the start, for thrown objects
};

/// A wedge: rises along its x from the ground to `height`, and ends there with a vertical drop.
struct Ramp {
  Pose pose{};  // of the middle of its lower edge
  double length = 6.0;
  double width = 4.0;
  double height = 1.0;
};

/// A slippery area of the road.
struct Patch {
  Pose pose{};  // of its middle; turned about z only
  double half_length = 5.0;
  double half_width = 3.0;
  double grip = 0.2;  // relative to the dry road
};

struct Track {
  /// The middle of the road, a closed line with points about 2 m apart, in the direction of the
  /// race. A lap begins and ends at the first point. Empty: open ground without laps.
  std::vector<Vec3> centre;
  double width = 11.0;
  std::vector<Wall> walls;
  std::vector<Obstacle> obstacles;
  std::vector<Ramp> ramps;
  std::vector<Patch> patches;
  Pose start{};  // of the car, see car.h
};

/// Rotated by `yaw_deg` about z: 0 along x, 90 along y.
Pose flat_pose(double x, double y, double z, double yaw_deg);

/// A closed smooth road through `corners`, with walls along both sides and the start on its first
/// point.
Track road_through(const std::vector<Vec3>& corners, double width);

/// The track of the program: about 390 m with a jump, three slippery patches and obstacles close to
/// the line.
Track home_track();

}  // namespace hedgehog::racer

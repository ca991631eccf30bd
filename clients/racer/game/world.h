// SPDX-License-Identifier: MIT
// Physics of the race: a Bullet world with a btRaycastVehicle. Bullet is hidden behind this header.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "clients/racer/game/controls.h"
#include "clients/racer/game/scene.h"
#include "clients/racer/game/track.h"

namespace hedgehog::racer {

/// One body that the car touches.
struct Contact {
  int body = 0;          // the number of the obstacle, or one of the constants below
  Vec3 point{};          // in the car's frame, the mean weighted by impulse
  Vec3 towards{};        // unit vector in the car's frame: from the car into the body
  double impulse = 0.0;  // Newton seconds
  static constexpr int kWalls = -1;
  static constexpr int kRamps = -2;
  static constexpr int kGround = -3;
};

/// One thread at a time; deterministic.
class World {
 public:
  /// Bullet's own step.
  static constexpr double kStepS = 1.0 / 120.0;

  explicit World(const Track& track);
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  void step(const Controls& controls);
  /// Puts the car there, at rest.
  void place(const Pose& pose);
  /// Moves every movable object more than `away` metres from the car back to its start.
  void reset_objects(double away);

  Pose car() const;
  Vec3 velocity() const;  // of the car, m/s, world
  std::array<Wheel, 4> wheels() const;
  std::vector<Pose> obstacles() const;
  /// Contacts of the car's body in the last step; those of the wheels are not included.
  std::vector<Contact> contacts() const;

 private:
  struct Bodies;
  std::unique_ptr<Bodies> bodies_;
};

}  // namespace hedgehog::racer

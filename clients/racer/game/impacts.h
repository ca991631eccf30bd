// SPDX-License-Identifier: MIT
// Contacts merged into impacts: one when the car runs into something, none while it scrapes along
// it, another when it is hit again or much harder.
#pragma once

#include <map>
#include <vector>

#include "clients/racer/game/race_event.h"
#include "clients/racer/game/world.h"

namespace hedgehog::racer {

/// Where on the car a contact is felt: towards the contact point on the body, in units of the car's
/// half sizes (so a corner is 45 degrees), with the elevation of the contact normal.
model::Vec3 felt_direction(const Contact& contact) noexcept;

class Impacts {
 public:
  /// Smaller impulses are ignored: 0.15 m/s of the car.
  static constexpr double kMinImpulse = 120.0;

  /// The impacts of one step of the race, `time_s` after the start; `contacts` are those of its
  /// steps of the world. Contact of the ground below is no blow: it is a landing; on the roof it is
  /// one.
  std::vector<Hit> take(const std::vector<Contact>& contacts, double time_s);

 private:
  struct Touch {
    double last_s = -1.0;      // time of the last contact
    double reported_s = -1.0;  // time of the last reported blow
    double impulse = 0.0;      // of that blow
    Vec3 direction{};
  };
  std::map<int, Touch> touches_;
};

}  // namespace hedgehog::racer

// SPDX-License-Identifier: MIT
// Contacts as a person counts them: one blow when the car runs into something, none while it
// scrapes along it, another when it is hit again or much harder.
#pragma once

#include <map>
#include <vector>

#include "clients/racer/game/happening.h"
#include "clients/racer/game/world.h"

namespace hedgehog::racer {

/// Where on the car a contact is felt: towards the body's point that was touched, in units of the
/// car's half sizes (so a corner is 45 degrees), up and down as the surfaces face each other.
model::Vec3 felt_direction(const Contact& contact) noexcept;

class Blows {
 public:
  /// Less is not worth telling: 0.15 m/s of the car.
  static constexpr double kMinImpulse = 120.0;

  /// The blows of one step of the race, `time_s` after the start; `contacts` are those of its
  /// steps of the world. The ground is no blow: it is a landing, or felt by the roof.
  std::vector<Hit> take(const std::vector<Contact>& contacts, double time_s);

 private:
  struct Touch {
    double last_s = -1.0;      // when there was contact
    double reported_s = -1.0;  // when a blow was reported
    double impulse = 0.0;      // of that blow
    Vec3 direction{};
  };
  std::map<int, Touch> touches_;
};

}  // namespace hedgehog::racer

// SPDX-License-Identifier: MIT
#include "clients/racer/game/impacts.h"

#include <cmath>

#include "clients/racer/game/car.h"

namespace hedgehog::racer {

namespace {

// Minimum time without contact before another blow.
constexpr double kApartS = 0.25;
// Ratio of impulses for another blow during continuous contact.
constexpr double kHarder = 2.0;
// Or from another side: cos 60 degrees.
constexpr double kOtherSide = 0.5;
// Minimum time between impacts from one body.
constexpr double kRestS = 0.1;

}  // namespace

model::Vec3 felt_direction(const Contact& contact) noexcept {
  const Vec3 side =
      model::unit_or({contact.point.x / kCarHalfSize.x, contact.point.y / kCarHalfSize.y, 0},
                     {contact.towards.x, contact.towards.y, 0});
  const double level = std::sqrt(std::max(0.0, 1.0 - contact.towards.z * contact.towards.z));
  return model::unit_or({level * side.x, level * side.y, contact.towards.z}, contact.towards);
}

std::vector<Hit> Impacts::take(const std::vector<Contact>& contacts, double time_s) {
  std::map<int, Contact> merged;
  for (const Contact& contact : contacts) {
    const Vec3 direction = felt_direction(contact);
    if (contact.body == Contact::kGround && direction.z < 0.0) continue;
    Contact& sum = merged[contact.body];
    sum.impulse += contact.impulse;
    sum.towards = sum.towards + contact.impulse * direction;
  }
  std::vector<Hit> hits;
  for (const auto& [body, contact] : merged) {
    Touch& touch = touches_[body];
    const Vec3 direction = unit_or(contact.towards, {1, 0, 0});
    const bool apart = touch.last_s < 0.0 || time_s - touch.last_s > kApartS;
    const bool rested = touch.reported_s < 0.0 || time_s - touch.reported_s > kRestS;
    const bool harder = contact.impulse > kHarder * touch.impulse;
    const bool elsewhere = dot(direction, touch.direction) < kOtherSide;
    if (apart) touch.impulse = 0.0;
    touch.last_s = time_s;
    if (contact.impulse < kMinImpulse) continue;
    if (apart || touch.impulse == 0.0 || (rested && (harder || elsewhere))) {
      hits.push_back({direction, contact.impulse});
      touch.reported_s = time_s;
      touch.impulse = contact.impulse;
      touch.direction = direction;
    }
  }
  return hits;
}

}  // namespace hedgehog::racer

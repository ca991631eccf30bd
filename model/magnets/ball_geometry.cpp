// SPDX-License-Identifier: MIT
#include "model/magnets/ball_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace hedgehog::model {
namespace {

/// Below this a pin's distance from the axis and the front's angle from +x are rounding errors.
constexpr double kNoTurn = 1e-6;

/// Removes rounding errors, so that the top pin is exactly (0,0,1).
Vec3 without_noise(Vec3 v) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(v[axis]) < 1e-9) v[axis] = 0.0;
  return unit_or(v, {0, 0, 1});
}

Vec3 turned_about_z(const Vec3& v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

void turn(std::vector<MagnetSite>& sites, double angle) {
  for (MagnetSite& site : sites) site.direction = turned_about_z(site.direction, angle);
}

/// The azimuth of the front, radians.
MagnetResult<double> front_azimuth(const Arrangement& whole, int front_pin) {
  const auto front = std::find_if(whole.pins.begin(), whole.pins.end(),
                                  [&](const MagnetSite& pin) { return pin.id == front_pin; });
  const std::string named = "pin " + std::to_string(front_pin);
  if (front == whole.pins.end())
    return MagnetError{"there is no " + named + " to be the front", GeometryPart::kFrontPin};
  const Vec3& direction = front->direction;
  if (std::hypot(direction.x, direction.y) < kNoTurn)
    return MagnetError{named + " is at a pole and shows no front", GeometryPart::kFrontPin};
  return std::atan2(direction.y, direction.x);
}

PinArray array_of(const Arrangement& arrangement, std::string name) {
  PinArray array{std::move(name), {}, {}};
  for (const MagnetSite& site : arrangement.pins) {
    while (array.ring_start.size() <= static_cast<std::size_t>(site.ring))
      array.ring_start.push_back(array.pins.size());
    array.pins.push_back({site.id, site.ring, without_noise(site.direction)});
  }
  array.ring_start.push_back(array.pins.size());
  return array;
}

BallPins pins_of(const Arrangement& arrangement, const BallGeometry& geometry) {
  return {array_of(arrangement, geometry.arrangement), PinCurves(arrangement, geometry.sizes)};
}

}  // namespace

MagnetResult<Arrangement> arrangement_of(const BallGeometry& geometry) {
  auto whole = arrangement_named(geometry.arrangement);
  if (whole.has_error()) return whole.error();
  const auto front = front_azimuth(*whole, geometry.front_pin);
  if (front.has_error()) return front.error();
  auto ball = without(*std::move(whole), geometry.removed_pins, geometry.removed_shields);
  if (ball.has_error()) return ball.error();
  if (ball->pins.empty()) return MagnetError{"no pin is left", GeometryPart::kRemovedPins};
  if (std::abs(*front) > kNoTurn) {
    turn(ball->pins, -*front);
    turn(ball->shields, -*front);
  }
  number_sites(*ball);
  if (auto overlap = check_fit(*ball, geometry.sizes)) return *std::move(overlap);
  return ball;
}

MagnetResult<std::shared_ptr<const BallPins>> ball_pins(const BallGeometry& geometry) {
  // Non-owning: the object is static.
  if (geometry == BallGeometry{})
    return std::shared_ptr<const BallPins>(std::shared_ptr<void>(), &thesis_ball());
  const auto arrangement = arrangement_of(geometry);
  if (arrangement.has_error()) return arrangement.error();
  return std::make_shared<const BallPins>(pins_of(*arrangement, geometry));
}

const BallPins& thesis_ball() {
  static const BallPins ball = pins_of(arrangement_of(BallGeometry{}).value(), {});
  return ball;
}

}  // namespace hedgehog::model

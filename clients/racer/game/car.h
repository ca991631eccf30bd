// SPDX-License-Identifier: MIT
// The car's sizes: a light buggy. Metres, kilograms; the car's origin is its centre of mass.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/vec3.h"

namespace hedgehog::racer {

inline constexpr double kCarMassKg = 800.0;
/// Half of the body: front, side, up.
inline constexpr model::Vec3 kCarHalfSize{1.7, 0.85, 0.35};
/// Height of the body's middle above the centre of mass.
inline constexpr double kCarBodyLift = 0.25;
inline constexpr double kWheelRadius = 0.36;
inline constexpr double kWheelWidth = 0.28;
/// Positions of the wheels relative to the centre of mass. The first two wheels are front left and
/// front right, then rear left and rear right.
inline constexpr double kAxleX = 1.15;
inline constexpr double kAxleY = 0.80;
/// Side force of a wheel on the dry road, relative to its load.
inline constexpr double kGrip = 1.5;
/// Maximum angle of the front wheels, in radians: 32 degrees at walking pace; decreasing with speed
/// to slightly more than the dry road allows.
inline double steering_lock(double speed_mps) noexcept {
  constexpr double kMaxRad = 0.56;
  constexpr double kSideways = kGrip * 9.81;
  const double square = std::max(speed_mps * speed_mps, 1.0);
  return std::min(kMaxRad, 1.15 * std::atan(2.0 * kAxleX * kSideways / square));
}
/// Height of the origin of a standing car.
inline constexpr double kCarStandsAt = 0.66;

}  // namespace hedgehog::racer

// SPDX-License-Identifier: MIT
// Pin force per ampere: the two values of the thesis, which differ by a factor of 2.
#pragma once

#include <string_view>

#include "model/units.h"

namespace hedgehog::model {

/// An axially magnetised rod that moves along a radius of the ball.
struct PinMagnet {
  double remanence_t = 0.0;
  double radius_m = 0.0;
  double length_m = 0.0;
  double inner_face_m = 0.0;  // from the centre of the ball to the near face, pin at offset 0
};

/// N45 on the 35 mm sphere (thesis sections 2.3 and 2.4, Table 2.2).
inline constexpr PinMagnet kThesisPin{1.37, 4e-3, 10e-3, 35e-3};

/// N per A m^2 of a point dipole that points at the rod and lies on its axis; exact:
/// (Br a^2 / 2) ((a^2 + z1^2)^-3/2 - (a^2 + z2^2)^-3/2) with the faces at z1 and z2.
double force_per_moment(const PinMagnet& pin, double extension_m = 0.0) noexcept;

struct FieldCalibration {
  std::string_view name;
  double force_slope_n_a = 0.0;  // outward, on a pin that the field aims at
};

/// 0.4 N at 15 A on a magnet on the sphere, at offset 0 (thesis Fig. 2.9, finite elements).
inline constexpr FieldCalibration kFeaCalibration{"fea", 0.02667};
/// Default of balls: median of three slopes (thesis Table 3.1), pin at rest, about 0.5 mm extended.
inline constexpr FieldCalibration kMeasuredCalibration{"measured", 0.0126};

}  // namespace hedgehog::model

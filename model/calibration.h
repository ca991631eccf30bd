// SPDX-License-Identifier: MIT
// Pin force per ampere. The thesis gives two values that differ by a factor of 2: its
// finite-element simulation (Fig. 2.9) and its measurement (Table 3.1). Both are kept; a ball uses
// `force_slope_n_a` of its device file.
#pragma once

#include <string_view>

#include "model/units.h"

namespace hedgehog::model {

/// An axially magnetised rod that moves along a radius of the ball.
struct PinMagnet {
  double remanence_t = 0.0;
  double radius_m = 0.0;
  double length_m = 0.0;
  /// From the centre of the ball to the near face, pin at offset 0.
  double inner_face_m = 0.0;
};

/// N45, 8 mm across, 10 mm long, on the 35 mm sphere (thesis sections 2.3 and 2.4, Table 2.2).
inline constexpr PinMagnet kThesisPin{1.37, 4e-3, 10e-3, 35e-3};

/// Force on a rod whose axis points at a dipole of 1 A m^2 which points back at it, N per A m^2.
/// Exact for a point dipole: (Br a^2 / 2) ((a^2 + z1^2)^-3/2 - (a^2 + z2^2)^-3/2) with the faces at
/// z1 and z2. `extension_m`: how far the pin is extended.
double force_per_moment(const PinMagnet& pin, double extension_m = 0.0) noexcept;

struct FieldCalibration {
  std::string_view name;
  /// Outward force on a pin that the field aims at, N / A.
  double force_slope_n_a = 0.0;
};

/// 0.4 N at 15 A on a magnet on the sphere, at offset 0 (thesis Fig. 2.9, finite elements).
inline constexpr FieldCalibration kFeaCalibration{"fea", 0.02667};
/// The median of the three measured slopes (thesis Table 3.1), of a pin at its rest position, about
/// 0.5 mm extended (section 3.1.1). Default of every ball.
inline constexpr FieldCalibration kMeasuredCalibration{"measured", 0.0126};

}  // namespace hedgehog::model

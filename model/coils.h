// SPDX-License-Identifier: MIT
// The electromagnet: three orthogonal windings around one core (thesis section 2.4). The calibrated
// coil matrix turns a demanded field into winding currents.
#pragma once

#include <array>

#include "model/units.h"
#include "model/vec3.h"

namespace hedgehog::model {

inline constexpr int kCoils = 3;

/// Direction in which the pins push out, in the device frame; its length is the current, in
/// ampere-equivalents, of one ideal winding along it. Not yet limited.
struct FieldDemand {
  Vec3 a;
};

/// Of the windings x, y, z, ampere. Not yet limited: only `LimitedCurrents` may be driven.
struct CoilCurrents {
  Vec3 a;
};

/// One device's electromagnet, as calibrated. Trivially copyable.
struct CoilModel {
  Mat3 matrix;  // demand (device frame) -> winding currents: signs, swaps and scale of this ball
  std::array<double, kCoils> r25_ohm{0.45, 0.45, 0.45};  // at 25 C, 0.05..10
  double inductance_h = 1.5e-3;                          // of each winding
  double supply_v = 12.0;                                // nominal supply of the bridges

  friend constexpr bool operator==(const CoilModel&, const CoilModel&) noexcept = default;
};

/// Relative increase of resistance about 25 C (reference: hardware.md section 1.3).
inline constexpr double kCopperPerKelvin = 0.00393;

constexpr Ohms resistance_at(Ohms r25, Celsius t) noexcept {
  return Ohms(r25.value * (1.0 + kCopperPerKelvin * (t.value - 25.0)));
}

/// The inverse of `resistance_at`.
constexpr Celsius temperature_at(Ohms r25, Ohms r) noexcept {
  return Celsius(25.0 + (r / r25 - 1.0) / kCopperPerKelvin);
}

/// Temperature error per relative error of the resistance of a winding at `t`.
constexpr double kelvins_per_share(Celsius t) noexcept {
  return 1.0 / kCopperPerKelvin + t.value - 25.0;
}

constexpr CoilCurrents currents_for(const FieldDemand& demand, const CoilModel& coils) noexcept {
  return {coils.matrix * demand.a};
}

/// The inverse. REQUIRES: determinant(coils.matrix) != 0 (checked when the device file is read).
constexpr FieldDemand field_of(const CoilCurrents& currents, const CoilModel& coils) noexcept {
  return {inverse(coils.matrix) * currents.a};
}

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// The electromagnet: three orthogonal windings around one core (thesis section 2.4). A demanded
// field becomes winding currents through the calibrated coil matrix, and winding currents become
// bridge voltages through each winding's resistance and inductance.
#pragma once

#include <array>

#include "model/units.h"
#include "model/vec3.h"

namespace hedgehog::model {

inline constexpr int kCoils = 3;

/// Demanded field: direction in which the pins push out, in the device frame. Its length is the
/// current, in ampere-equivalents, of one ideal winding along it. Not yet limited.
struct FieldDemand {
  Vec3 a;
};

/// Currents of the windings x, y, z in ampere. Not yet limited: only `LimitedCurrents`
/// (model/limit/limited_currents.h) may be driven.
struct CoilCurrents {
  Vec3 a;
};

/// One device's electromagnet, as calibrated. Trivially copyable.
struct CoilModel {
  /// Demand (device frame) -> winding currents: signs, swaps and scale of this ball.
  Mat3 matrix;
  /// Resistance of each winding at 25 C, ohm, 0.05..10.
  std::array<double, kCoils> r25_ohm{0.45, 0.45, 0.45};
  /// Inductance of each winding, henry.
  double inductance_h = 1.5e-3;
  /// Nominal supply of the bridges, volt.
  double supply_v = 12.0;

  friend constexpr bool operator==(const CoilModel&, const CoilModel&) noexcept = default;
};

/// Copper: +0.393 %/K about 25 C (reference: hardware.md section 1.3).
inline constexpr double kCopperPerKelvin = 0.00393;

/// Resistance of a winding of `r25` at temperature `t`.
constexpr Ohms resistance_at(Ohms r25, Celsius t) noexcept {
  return Ohms(r25.value * (1.0 + kCopperPerKelvin * (t.value - 25.0)));
}

/// The temperature at which a winding of `r25` has resistance `r`: the inverse of `resistance_at`.
constexpr Celsius temperature_at(Ohms r25, Ohms r) noexcept {
  return Celsius(25.0 + (r / r25 - 1.0) / kCopperPerKelvin);
}

/// Temperature error, K, per relative error of the resistance of a winding at `t`.
constexpr double kelvins_per_share(Celsius t) noexcept {
  return 1.0 / kCopperPerKelvin + t.value - 25.0;
}

/// The winding currents that produce the field `demand`.
constexpr CoilCurrents currents_for(const FieldDemand& demand, const CoilModel& coils) noexcept {
  return {coils.matrix * demand.a};
}

/// The field that the winding currents `currents` produce: the inverse of `currents_for`. REQUIRES:
/// determinant(coils.matrix) != 0 (checked when the device file is read).
constexpr FieldDemand field_of(const CoilCurrents& currents, const CoilModel& coils) noexcept {
  return {inverse(coils.matrix) * currents.a};
}

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// Physical quantities as types, so that units cannot be mixed up. On the wire, in configuration and
// in logs the unit is a suffix of the name instead (`current_a`, `temperature_c`). Vectors and
// tables of constants carry the suffix in their field names too.
#pragma once

#include <compare>
#include <numbers>

namespace hedgehog::model {

template <class Unit>
struct Quantity {
  double value = 0.0;

  constexpr Quantity() noexcept = default;
  constexpr explicit Quantity(double v) noexcept : value(v) {}

  friend constexpr auto operator<=>(const Quantity&, const Quantity&) noexcept = default;
  friend constexpr Quantity operator+(Quantity a, Quantity b) noexcept {
    return Quantity(a.value + b.value);
  }
  friend constexpr Quantity operator-(Quantity a, Quantity b) noexcept {
    return Quantity(a.value - b.value);
  }
  friend constexpr Quantity operator-(Quantity a) noexcept { return Quantity(-a.value); }
  friend constexpr Quantity operator*(double k, Quantity a) noexcept {
    return Quantity(k * a.value);
  }
  friend constexpr Quantity operator*(Quantity a, double k) noexcept {
    return Quantity(k * a.value);
  }
  friend constexpr Quantity operator/(Quantity a, double k) noexcept {
    return Quantity(a.value / k);
  }
  friend constexpr double operator/(Quantity a, Quantity b) noexcept { return a.value / b.value; }
};

using Amps = Quantity<struct AmpsUnit>;
using Ohms = Quantity<struct OhmsUnit>;
/// A temperature, or a difference of two (then in kelvins).
using Celsius = Quantity<struct CelsiusUnit>;

/// Angles are radians in arithmetic and degrees in names that end in `_deg`.
inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

}  // namespace hedgehog::model

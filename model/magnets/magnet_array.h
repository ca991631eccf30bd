// SPDX-License-Identifier: MIT
// An arrangement with sizes: fit, gaps and mass. Design time and start-up: allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/magnets/arrangement.h"
#include "model/magnets/pair/cylinder_magnet.h"
#include "model/magnets/pair/pair_force.h"

namespace hedgehog::model {

/// All pins are equal, and so are all shields, of opposite polarity; inner faces on the sphere.
struct ArraySizes {
  CylinderMagnet pin = kThesisPinMagnet;
  CylinderMagnet shield = kThesisShieldMagnet;
  double sphere_radius_mm = 35.0;

  friend bool operator==(const ArraySizes&, const ArraySizes&) = default;
  MagnetPair pin_and_pin() const noexcept { return {pin, pin, sphere_radius_mm}; }
  MagnetPair pin_and_shield() const noexcept { return {pin, shield, sphere_radius_mm}; }
  MagnetPair shield_and_shield() const noexcept { return {shield, shield, sphere_radius_mm}; }
};

/// Error in the sizes alone, one sentence; nullopt if valid.
std::optional<std::string> problem_with(const ArraySizes& sizes);

enum class MagnetKind : std::uint8_t { kPin, kShield };
std::string_view name_of(MagnetKind kind) noexcept;

/// The nearest two magnets of two kinds. A negative gap is the overlap.
struct MagnetGap {
  MagnetKind kind_a = MagnetKind::kPin;
  int id_a = 0;
  MagnetKind kind_b = MagnetKind::kPin;
  int id_b = 0;
  double angle_deg = 0.0;
  double gap_mm = 0.0;
};

/// Of each existing pair of kinds, pins at offset 0: pin-pin, pin-shield, shield-shield.
std::vector<MagnetGap> smallest_gaps(const Arrangement& arrangement, const ArraySizes& sizes);

/// nullopt if the array can be built; else the error: invalid sizes, or the worst overlap.
std::optional<MagnetError> check_fit(const Arrangement& arrangement, const ArraySizes& sizes);

/// Pins and shields together, without plastic.
double magnets_mass_g(const Arrangement& arrangement, const ArraySizes& sizes) noexcept;

}  // namespace hedgehog::model

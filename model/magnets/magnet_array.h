// SPDX-License-Identifier: MIT
// An arrangement with sizes: whether the magnets fit, how far apart they are, what they weigh.
// Design time and start-up: allocates.
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

/// All pins are equal, and so are all shields. Shields have the opposite polarity; inner faces
/// stand on the sphere.
struct ArraySizes {
  CylinderMagnet pin = kThesisPinMagnet;
  CylinderMagnet shield = kThesisShieldMagnet;
  double sphere_radius_mm = 35.0;

  friend bool operator==(const ArraySizes&, const ArraySizes&) = default;
  MagnetPair pin_and_pin() const noexcept { return {pin, pin, sphere_radius_mm}; }
  MagnetPair pin_and_shield() const noexcept { return {pin, shield, sphere_radius_mm}; }
  MagnetPair shield_and_shield() const noexcept { return {shield, shield, sphere_radius_mm}; }
};

/// What is wrong with the sizes by themselves, one sentence.
std::optional<std::string> problem_with(const ArraySizes& sizes);

enum class MagnetKind : std::uint8_t { kPin, kShield };
std::string_view name_of(MagnetKind kind) noexcept;

/// The nearest two magnets of two kinds. Negative: they overlap by so much.
struct MagnetGap {
  MagnetKind kind_a = MagnetKind::kPin;
  int id_a = 0;
  MagnetKind kind_b = MagnetKind::kPin;
  int id_b = 0;
  double angle_deg = 0.0;
  double gap_mm = 0.0;
};

/// The smallest gap of each pair of kinds that there is, pins at offset 0: pin-pin, pin-shield,
/// shield-shield. Equal sizes make the smallest angle the smallest gap.
std::vector<MagnetGap> smallest_gaps(const Arrangement& arrangement, const ArraySizes& sizes);

/// Nothing when the array can be built; else what is wrong: sizes, or the overlap that is worst.
std::optional<MagnetError> check_fit(const Arrangement& arrangement, const ArraySizes& sizes);

/// Pins and shields together, without plastic, g.
double magnets_mass_g(const Arrangement& arrangement, const ArraySizes& sizes) noexcept;

}  // namespace hedgehog::model

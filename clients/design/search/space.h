// SPDX-License-Identifier: MIT
// Designs evaluated in a search, and the demands on them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/design/input/design.h"

namespace hedgehog::design {

struct SearchSpace {
  /// Names of whole arrays; each is evaluated with the fan's opening.
  std::vector<std::string> arrays;
  std::vector<Size> pins;
  std::vector<Size> shields;
  std::vector<double> spheres_mm;
  /// N on an aimed pin; empty: the force of the thesis' electromagnet at 15 A for that pin and
  /// sphere.
  std::vector<double> coil_forces_n;

  std::size_t size() const noexcept {
    return arrays.size() * pins.size() * shields.size() * spheres_mm.size() *
           std::max<std::size_t>(1, coil_forces_n.size());
  }
};

struct Demands {
  /// Plastic between any two magnets, mm.
  double wall_mm = 0.3;
  /// Every pin must rest, be held and stay within its travel even if all shields are weaker by this
  /// fraction.
  double margin = 0.02;
  /// Of the typical pin, with the full coil force.
  double min_extension_mm = 0.5;
  /// Maximum extension of any pin, limited by the casing.
  double travel_mm = 1.5;
};

/// A design that meets the demands.
struct Found {
  Design design;
  std::size_t pins = 0;
  std::size_t shields = 0;
  /// Of the typical pin (`typical_of`): rest without current and extension from there. On a front
  /// those of the ball as built, with the fan's opening; before, those of the whole array, which
  /// differ by some hundredths of a millimetre.
  double rest_mm = 0.0;
  double extension_mm = 0.0;
  /// With the casing printed solid.
  double mass_g = 0.0;
  double outer_diameter_mm = 0.0;
  /// The casing's thinnest wall at the default clearance; below 0 cavities overlap. On a front
  /// only.
  double wall_mm = 0.0;
};

/// No worse in any of pin count, extension, mass and outer diameter, and better in at least one.
bool dominates(const Found& a, const Found& b) noexcept;

/// Each design as built, or nullopt if that does not meet the demands; as many as given.
using Check = std::function<std::vector<std::optional<Found>>(const std::vector<Found>&)>;

struct CheckedFront {
  std::vector<Found> front;
  /// Checked and refused.
  std::size_t refused = 0;
};

/// Of the designs that `check` accepts, as returned by it, those that no other dominates, in a
/// fixed order: the smallest ball first, then the most pins, the largest extension, the least mass.
/// So the first is the smallest feasible ball, with the most pins and the largest extension
/// possible. A check is expensive, so only designs on the front of those not refused yet are
/// checked.
CheckedFront checked_front(std::vector<Found> found, const Check& check);

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
// Which designs a search looks at, and what it asks of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/design/input/design.h"

namespace hedgehog::design {

struct SearchSpace {
  /// Names of whole arrays; each is looked at with the fan's opening.
  std::vector<std::string> arrays;
  std::vector<Size> pins;
  std::vector<Size> shields;
  std::vector<double> spheres_mm;
  /// N on an aimed pin; empty: what the thesis' electromagnet can do at 15 A on that pin and
  /// sphere.
  std::vector<double> coil_forces_n;

  std::size_t size() const noexcept {
    return arrays.size() * pins.size() * shields.size() * spheres_mm.size() *
           std::max<std::size_t>(1, coil_forces_n.size());
  }
};

struct Demands {
  /// Plastic between any two magnets.
  double wall_mm = 0.3;
  /// Every pin must rest, be held and have room even when all shields are weaker by this part.
  double margin = 0.02;
  /// Of the typical pin, with the coil's full force.
  double min_extension_mm = 0.5;
  /// No pin may be pushed farther out than this: there is the casing.
  double travel_mm = 1.5;
};

/// A design that meets the demands.
struct Found {
  Design design;
  std::size_t pins = 0;
  std::size_t shields = 0;
  /// Of the typical pin (`typical_of`): where it is without current and how far it moves from
  /// there. On a front those of the ball as it is built, with the fan's opening; before, those of
  /// the whole array, some hundredths of a millimetre off.
  double rest_mm = 0.0;
  double extension_mm = 0.0;
  /// With the casing printed solid.
  double mass_g = 0.0;
  double outer_diameter_mm = 0.0;
  /// The casing's thinnest wall at the usual clearance; below 0 cavities run into each other. On a
  /// front only.
  double wall_mm = 0.0;
};

/// No worse in any of pin count, extension, mass and outer diameter, and better in one.
bool dominates(const Found& a, const Found& b) noexcept;

/// Each as it would be built, or nothing where that does not meet the demands; as long as what it
/// was given.
using Check = std::function<std::vector<std::optional<Found>>(const std::vector<Found>&)>;

struct CheckedFront {
  std::vector<Found> front;
  /// Asked about and refused.
  std::size_t refused = 0;
};

/// Of those that `check` lets stay, as it gives them back, the ones that no other dominates, in a
/// fixed order: the smallest ball first, of equals the most pins, the largest extension, the least
/// mass. So the first is the smallest ball that does what is asked, with as many pins, that move as
/// far, as it can have. A check is dear, so only those are asked about that are on a front of what
/// has not been refused yet.
CheckedFront checked_front(std::vector<Found> found, const Check& check);

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
// One ball on the drawing board: which array, which magnets, on which sphere, pushed how hard.
#pragma once

#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/design/input/sizes.h"
#include "model/magnets/arrangement.h"
#include "model/magnets/magnet_array.h"
#include "model/magnets/pair/pair_force.h"

namespace hedgehog::design {

/// As the daemon takes them. Force curves begin 2.5 mm inside the sphere.
inline constexpr double kMinSphereMm = 5.0;
inline constexpr double kMaxSphereMm = 500.0;

struct Design {
  /// As `find_arrangement` knows them. Ignored when `positions` is there.
  std::string array = "tkD-86";
  /// A CSV file with the places of all magnets; empty: none.
  std::string positions;
  Size magnet{8.0, 10.0};
  Size shield{4.0, 10.0};
  double sphere_mm = 35.0;
  double remanence_t = model::kN45RemanenceT;
  std::vector<int> removed_pins;
  std::vector<int> removed_shields;
  /// What the electromagnet can push with, N (thesis section 2.3: 0.4).
  double coil_force_n = 0.4;
  model::ForceSettings settings;

  model::ArraySizes sizes() const noexcept {
    return {{magnet.diameter_mm, magnet.height_mm, remanence_t},
            {shield.diameter_mm, shield.height_mm, remanence_t},
            sphere_mm};
  }
  /// Nothing taken out, nothing put elsewhere.
  bool whole() const noexcept {
    return positions.empty() && removed_pins.empty() && removed_shields.empty();
  }
  friend bool operator==(const Design& a, const Design& b) noexcept {
    return a.array == b.array && a.positions == b.positions && a.magnet == b.magnet &&
           a.shield == b.shield && a.sphere_mm == b.sphere_mm && a.remanence_t == b.remanence_t &&
           a.removed_pins == b.removed_pins && a.removed_shields == b.removed_shields &&
           a.coil_force_n == b.coil_force_n;
  }
};

/// "D", "tI", "cD", "wD", "tkD", "GP(m,n)"; followed by "-36", "-66", "-86", ... (six pins fewer)
/// the same with the fan's opening at the bottom: without the lowest pin, its five neighbours and
/// the shields that touch two of these. "-86-5" and "-86-20": only those that touch three, all that
/// touch one. The complaint about another name says which was meant.
Result<model::Arrangement> find_arrangement(const std::string& name);

/// The design's own magnets, without those that are removed. Not checked for overlaps.
Result<model::Arrangement> arrangement_of(const Design& design);

/// `arrangement_of`, and a complaint (65) when magnets are in each other's way.
Result<model::Arrangement> buildable_arrangement(const Design& design);

/// The thesis' magnets on its sphere, whatever the array, nothing removed.
bool has_thesis_magnets(const Design& design) noexcept;

/// These, pushed and computed as in the thesis (sections 2.2, 2.3: 0.4 N, near forces exact): what
/// the thesis prints can stand beside it.
bool is_of_the_thesis(const Design& design) noexcept;

/// "tkD-86, pins 8x10, shields 4x10, sphere 35 mm".
std::string to_text(const Design& design);

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
// Parameters of a ball: array, magnets, sphere, force of the coil.
#pragma once

#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/design/input/sizes.h"
#include "model/magnets/arrangement.h"
#include "model/magnets/magnet_array.h"
#include "model/magnets/pair/pair_force.h"

namespace hedgehog::design {

/// Bounds as in the daemon. Force curves begin 2.5 mm inside the sphere.
inline constexpr double kMinSphereMm = 5.0;
inline constexpr double kMaxSphereMm = 500.0;

struct Design {
  /// A name accepted by `find_arrangement`. Ignored if `positions` is set.
  std::string array = "tkD-86";
  /// A CSV file with the positions of all magnets; empty: none.
  std::string positions;
  Size magnet{8.0, 10.0};
  Size shield{4.0, 10.0};
  double sphere_mm = 35.0;
  double remanence_t = model::kN45RemanenceT;
  std::vector<int> removed_pins;
  std::vector<int> removed_shields;
  /// Force of the electromagnet, N (thesis section 2.3: 0.4).
  double coil_force_n = 0.4;
  model::ForceSettings settings;

  model::ArraySizes sizes() const noexcept {
    return {{magnet.diameter_mm, magnet.height_mm, remanence_t},
            {shield.diameter_mm, shield.height_mm, remanence_t},
            sphere_mm};
  }
  /// No magnet removed, no positions file.
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

/// "D", "tI", "cD", "wD", "tkD", "GP(m,n)"; with the suffix "-36", "-66", "-86", ... (six pins
/// fewer) the same with the fan's opening at the bottom: without the lowest pin, its five
/// neighbours and the shields that touch two of these. "-86-5" and "-86-20": without only those
/// that touch three, all that touch one. The error for an unknown name suggests the nearest one.
Result<model::Arrangement> find_arrangement(const std::string& name);

/// The design's magnets, without those that are removed. Not checked for overlaps.
Result<model::Arrangement> arrangement_of(const Design& design);

/// `arrangement_of`, with an error (65) if magnets overlap.
Result<model::Arrangement> buildable_arrangement(const Design& design);

/// True for the thesis' magnets on its sphere, with any array, nothing removed.
bool has_thesis_magnets(const Design& design) noexcept;

/// True if it also has the thesis' coil force and force model (sections 2.2, 2.3: 0.4 N, near
/// forces exact): results are comparable with those printed in the thesis.
bool is_of_the_thesis(const Design& design) noexcept;

/// "tkD-86, pins 8x10, shields 4x10, sphere 35 mm".
std::string to_text(const Design& design);

}  // namespace hedgehog::design

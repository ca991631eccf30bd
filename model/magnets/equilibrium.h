// SPDX-License-Identifier: MIT
// Joint equilibrium of all pins, each free to move, and its stability. Without mechanical stops.
// Design time only: allocates.
#pragma once

#include <span>
#include <vector>

#include "model/magnets/magnet_array.h"

namespace hedgehog::model {

struct Equilibrium {
  /// Offsets in the order of the arrangement's pins, mm.
  std::vector<double> offsets_mm;
  /// Eigenvalues of -dF_i/do_j, N/mm, ascending: all positive if the equilibrium is stable.
  std::vector<double> stiffness_n_mm;
  /// Largest residual force on a pin, N.
  double residual_n = 0.0;
  int iterations = 0;

  bool stable() const noexcept { return !stiffness_n_mm.empty() && stiffness_n_mm.front() > 0.0; }
};

/// Newton's method from the rest position of each pin alone. `coil_force_n`: outward force on each
/// pin, in the arrangement's order; empty for none. An error if it finds none within +-10 mm, as
/// with an unstable array.
MagnetResult<Equilibrium> find_equilibrium(const Arrangement& arrangement, const ArraySizes& sizes,
                                           const ForceSettings& settings = {},
                                           std::span<const double> coil_force_n = {});

}  // namespace hedgehog::model

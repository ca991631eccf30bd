// SPDX-License-Identifier: MIT
// Joint equilibrium of all pins without mechanical stops. Design time only: allocates.
#pragma once

#include <span>
#include <vector>

#include "model/magnets/magnet_array.h"

namespace hedgehog::model {

struct Equilibrium {
  std::vector<double> offsets_mm;      // in the order of the arrangement's pins
  std::vector<double> stiffness_n_mm;  // eigenvalues of -dF_i/do_j, ascending: positive if stable
  double residual_n = 0.0;             // largest residual force on a pin
  int iterations = 0;

  bool stable() const noexcept { return !stiffness_n_mm.empty() && stiffness_n_mm.front() > 0.0; }
};

/// Newton's method from the rest position of each pin alone; an error if it finds none within
/// +-10 mm. `coil_force_n`: outward, in the arrangement's order of pins; empty for none.
MagnetResult<Equilibrium> find_equilibrium(const Arrangement& arrangement, const ArraySizes& sizes,
                                           const ForceSettings& settings = {},
                                           std::span<const double> coil_force_n = {});

}  // namespace hedgehog::model

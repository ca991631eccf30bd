// SPDX-License-Identifier: MIT
// All pins at once: where every one of them is at rest while the others are free too, and whether
// that stays. There is no mechanical stop in it. Design time only: allocates.
#pragma once

#include <span>
#include <vector>

#include "model/magnets/magnet_array.h"

namespace hedgehog::model {

struct Equilibrium {
  /// In the order of the arrangement's pins, mm.
  std::vector<double> offsets_mm;
  /// Eigenvalues of -dF_i/do_j, N/mm, ascending: all positive when the array stays as it is.
  std::vector<double> stiffness_n_mm;
  /// The largest force that is left on a pin, N.
  double residual_n = 0.0;
  int iterations = 0;

  bool stable() const noexcept { return !stiffness_n_mm.empty() && stiffness_n_mm.front() > 0.0; }
};

/// Newton's method from where each pin would rest alone. `coil_force_n`: an outward force on each
/// pin, in the arrangement's order; empty for none. An error when it finds none within +-10 mm,
/// which is what an unstable array does.
MagnetResult<Equilibrium> find_equilibrium(const Arrangement& arrangement, const ArraySizes& sizes,
                                           const ForceSettings& settings = {},
                                           std::span<const double> coil_force_n = {});

}  // namespace hedgehog::model

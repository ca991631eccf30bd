// SPDX-License-Identifier: MIT
// What a force curve means: where a pin rests, how stiffly, and how far a push moves it (thesis
// section 2.3, Table 2.1). Only the pin that is looked at moves; for all at once see equilibrium.h.
// Design time only: allocates.
#pragma once

#include <optional>
#include <vector>

#include "model/magnets/electromagnet.h"
#include "model/magnets/force_curve.h"

namespace hedgehog::model {

struct Characterisation {
  ForceCurve curve;
  /// The first offset on the grid's range where the force falls through zero: the pin rests there.
  /// Nothing: it is pushed out, or in, everywhere.
  std::optional<double> rest_mm;
  /// The first offset beyond, where the force rises through zero: from there on the pin is
  /// expelled.
  std::optional<double> unstable_mm;
  /// -dF/do at rest, N/mm; 0 without rest.
  double stiffness_n_mm = 0.0;
  /// The strongest pull inwards beyond the rest (without one: the smallest force on the range), and
  /// where. A coil force larger than -minimum_n expels the pin.
  double minimum_n = 0.0;
  double minimum_mm = 0.0;

  bool stable() const noexcept { return rest_mm.has_value(); }
};

/// Roots are refined with the exact sum, to 1e-5 mm; where the minimum is, to 1e-3 mm (which moves
/// its force by no more than 1e-6 N).
Characterisation characterise(const PinForce& force, const OffsetGrid& grid = kThesisGrid);

/// One for each class.
std::vector<Characterisation> characterise(const std::vector<PinClass>& classes,
                                           const ArraySizes& sizes, const ForceSettings& settings,
                                           const OffsetGrid& grid = kThesisGrid);

/// How far a constant push of `coil_force_n` >= 0 moves the pin out of its rest (thesis Table 2.1
/// with 0.4 N), mm. Nothing: no rest, or the array never pulls back so hard on the grid's range.
std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   double coil_force_n);

/// The same for a current aimed at the pin; the push weakens while the pin moves out (reference:
/// physics.md section 6). REQUIRES: current_a >= 0.
std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   const Electromagnet& coil, double current_a);

}  // namespace hedgehog::model

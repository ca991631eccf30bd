// SPDX-License-Identifier: MIT
// Properties of a force curve: rest position, stiffness, and displacement by a push (thesis section
// 2.3, Table 2.1). Only the examined pin moves; for all pins see equilibrium.h. `extension_mm` is
// the thesis' measure, from zero crossing to zero crossing; `stroke` is the travel of a ball's pin
// between shell and casing, as in `PinCurves`. Design time only: allocates.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/magnets/electromagnet.h"
#include "model/magnets/force_curve.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::model {

/// State of a pin of a ball without current.
enum class Standing : std::uint8_t {
  kRests,
  /// Pulled onto the shell by the shields.
  kPressed,
  /// No restoring force.
  kPushedOut,
};

struct Characterisation {
  ForceCurve curve;
  /// The first offset on the grid's range where the force falls through zero: the rest position.
  /// nullopt: it is pushed out, or in, everywhere.
  std::optional<double> rest_mm;
  /// The first offset beyond it where the force rises through zero: beyond that the pin is
  /// expelled.
  std::optional<double> unstable_mm;
  /// -dF/do at rest, N/mm; 0 without rest position.
  double stiffness_n_mm = 0.0;
  /// The strongest inward force beyond the rest position (without one: the smallest force on the
  /// range), and its offset. A coil force larger than -minimum_n expels the pin.
  double minimum_n = 0.0;
  double minimum_mm = 0.0;

  /// Force at offset 0, N, where the shell stops an inward-moving pin.
  double shell_n = 0.0;
  /// Position of the pin in a ball without current: on the shell if `shell_n` is below 0, else
  /// where the force first falls through zero beyond it. nullopt: pushed out.
  std::optional<double> standing_mm;

  bool stable() const noexcept { return rest_mm.has_value(); }
  Standing standing() const noexcept {
    return !standing_mm    ? Standing::kPushedOut
           : shell_n < 0.0 ? Standing::kPressed
                           : Standing::kRests;
  }
  /// Preload onto the shell, N: a smaller push does not move the pin.
  double preload_n() const noexcept { return standing() == Standing::kPressed ? -shell_n : 0.0; }
};

/// Roots are refined with the exact sum, to 1e-5 mm; the position of the minimum to 1e-3 mm (an
/// error of its force of at most 1e-6 N).
Characterisation characterise(const PinForce& force, const OffsetGrid& grid = kThesisGrid);

/// One for each class.
std::vector<Characterisation> characterise(const std::vector<PinClass>& classes,
                                           const ArraySizes& sizes, const ForceSettings& settings,
                                           const OffsetGrid& grid = kThesisGrid);

/// Displacement of the pin from rest by a constant push of `coil_force_n` >= 0 (thesis Table 2.1
/// with 0.4 N), mm, without shell and casing. nullopt: no rest position, or the array nowhere
/// balances the push on the grid's range.
std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   double coil_force_n);

/// The same for a current aimed at the pin; the push weakens while the pin moves out (reference:
/// physics.md section 6). REQUIRES: current_a >= 0.
std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   const Electromagnet& coil, double current_a);

/// Outward push on a pin at an offset, N; >= 0.
using Push = std::function<double(double offset_mm)>;
Push constant_push(double force_n);
/// Push by a current aimed at the pin.
Push coil_push(const Electromagnet& coil, double current_a, const ArraySizes& sizes);

struct Stroke {
  /// Displacement from the position without current, at most to the casing.
  double extension_mm = 0.0;
  /// Stopped by the casing, not by the magnets.
  bool at_casing = false;
  /// The magnets would not stop it anywhere on the curve's range.
  bool expelled = false;
};

/// Travel of the pin of a ball under a push. nullopt: it is pushed out even without it.
std::optional<Stroke> stroke(const PinForce& force, const Characterisation& character,
                             const Push& push, const PinTravel& travel = {});

}  // namespace hedgehog::model

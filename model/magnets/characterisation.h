// SPDX-License-Identifier: MIT
// What a force curve means: where a pin rests, how stiffly, and how far a push moves it (thesis
// section 2.3, Table 2.1). Only the pin that is looked at moves; for all at once see equilibrium.h.
// `extension_mm` is the thesis' measure, from zero crossing to crossing; `stroke` is what the pin
// of a ball does between its shell and its casing, as `PinCurves` has it too. Design time only:
// allocates.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/magnets/electromagnet.h"
#include "model/magnets/force_curve.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::model {

/// What a pin of a ball does without current.
enum class Standing : std::uint8_t {
  kRests,
  /// On the shell, onto which the shields pull it.
  kPressed,
  /// Nothing draws it back.
  kPushedOut,
};

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

  /// The force at offset 0, N, where the shell stops the pin on its way in.
  double shell_n = 0.0;
  /// Where the pin is without current in a ball: on the shell where `shell_n` is below 0, else
  /// where the force first falls through zero beyond. Nothing: pushed out.
  std::optional<double> standing_mm;

  bool stable() const noexcept { return rest_mm.has_value(); }
  Standing standing() const noexcept {
    return !standing_mm    ? Standing::kPushedOut
           : shell_n < 0.0 ? Standing::kPressed
                           : Standing::kRests;
  }
  /// With how much it is pressed onto the shell, N: below that no push moves it.
  double preload_n() const noexcept { return standing() == Standing::kPressed ? -shell_n : 0.0; }
};

/// Roots are refined with the exact sum, to 1e-5 mm; where the minimum is, to 1e-3 mm (which moves
/// its force by no more than 1e-6 N).
Characterisation characterise(const PinForce& force, const OffsetGrid& grid = kThesisGrid);

/// One for each class.
std::vector<Characterisation> characterise(const std::vector<PinClass>& classes,
                                           const ArraySizes& sizes, const ForceSettings& settings,
                                           const OffsetGrid& grid = kThesisGrid);

/// How far a constant push of `coil_force_n` >= 0 moves the pin out of its rest (thesis Table 2.1
/// with 0.4 N), mm, were there neither shell nor casing. Nothing: no rest, or the array never pulls
/// back so hard on the grid's range.
std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   double coil_force_n);

/// The same for a current aimed at the pin; the push weakens while the pin moves out (reference:
/// physics.md section 6). REQUIRES: current_a >= 0.
std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   const Electromagnet& coil, double current_a);

/// Outward force of whatever pushes a pin at an offset, N; >= 0.
using Push = std::function<double(double offset_mm)>;
Push constant_push(double force_n);
/// A current that is aimed at the pin.
Push coil_push(const Electromagnet& coil, double current_a, const ArraySizes& sizes);

struct Stroke {
  /// From where the pin stands without current to where it is, at most to the casing.
  double extension_mm = 0.0;
  /// The casing stops it, not the magnets.
  bool at_casing = false;
  /// The magnets would not stop it anywhere on the curve's range.
  bool expelled = false;
};

/// How far a push moves the pin of a ball. Nothing: it is pushed out without it.
std::optional<Stroke> stroke(const PinForce& force, const Characterisation& character,
                             const Push& push, const PinTravel& travel = {});

}  // namespace hedgehog::model

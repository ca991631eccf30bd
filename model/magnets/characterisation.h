// SPDX-License-Identifier: MIT
// Properties of a force curve: rest, stiffness, displacement by a push (thesis section 2.3, Table
// 2.1). Only the examined pin moves; all pins: equilibrium.h. Design time only: allocates.
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
  kPressed,    // pulled onto the shell by the shields
  kPushedOut,  // no restoring force
};

struct Characterisation {
  ForceCurve curve;
  /// The first offset where the force falls through zero; nullopt: pushed out, or in, everywhere.
  std::optional<double> rest_mm;
  std::optional<double> unstable_mm;  // the next zero crossing; beyond it the pin is expelled
  double stiffness_n_mm = 0.0;        // -dF/do at rest; 0 without rest position
  /// The strongest inward force beyond the rest position (without one: the smallest force on the
  /// range), and its offset. A coil force larger than -minimum_n expels the pin.
  double minimum_n = 0.0;
  double minimum_mm = 0.0;

  double shell_n = 0.0;  // force at offset 0, where the shell stops an inward-moving pin
  /// Position without current: on the shell if `shell_n` is below 0, else where the force first
  /// falls through zero beyond it. nullopt: pushed out.
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

/// Roots are refined with the exact sum, to 1e-5 mm; the minimum to 1e-3 mm (1e-6 N).
Characterisation characterise(const PinForce& force, const OffsetGrid& grid = kThesisGrid);

std::vector<Characterisation> characterise(const std::vector<PinClass>& classes,
                                           const ArraySizes& sizes, const ForceSettings& settings,
                                           const OffsetGrid& grid = kThesisGrid);

/// Displacement from rest by a constant push >= 0 (thesis Table 2.1 with 0.4 N), without shell and
/// casing. nullopt: no rest position, or the array nowhere balances the push on the grid's range.
std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   double coil_force_n);

/// By a current >= 0; its push weakens as the pin moves out (reference: physics.md section 6).
std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   const Electromagnet& coil, double current_a);

/// Outward push on a pin at an offset, N, >= 0: constant, or by a current aimed at the pin.
using Push = std::function<double(double offset_mm)>;
Push constant_push(double force_n);
Push coil_push(const Electromagnet& coil, double current_a, const ArraySizes& sizes);

struct Stroke {
  double extension_mm = 0.0;  // from the position without current, at most to the casing
  bool at_casing = false;     // stopped by the casing, not by the magnets
  bool expelled = false;      // the magnets would not stop it anywhere on the curve's range
};

/// Travel of a ball's pin between shell and casing. nullopt: it is pushed out even without a push.
std::optional<Stroke> stroke(const PinForce& force, const Characterisation& character,
                             const Push& push, const PinTravel& travel = {});

}  // namespace hedgehog::model

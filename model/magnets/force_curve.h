// SPDX-License-Identifier: MIT
// F(o) of a pin (thesis (2.4)): the axial force of all other magnets of the array on it when only
// this pin is moved to offset o. Design time: curves allocate; the force itself does not.
#pragma once

#include <span>
#include <vector>

#include "model/magnets/magnet_array.h"
#include "model/magnets/pair/pair_force.h"
#include "model/magnets/symmetry_classes.h"

namespace hedgehog::model {

/// The force on any pin of one class. Keeps a reference: the class must outlive it.
class PinForce {
 public:
  /// REQUIRES: check_fit() returned no error.
  PinForce(const PinClass& pin_class, const ArraySizes& sizes, const ForceSettings& settings)
      : class_(&pin_class), sizes_(sizes), settings_(settings) {}

  /// Outwards positive; the error is the sum of the pairs' bounds.
  PairForce at(double offset_mm) const noexcept;

  const PinClass& pin_class() const noexcept { return *class_; }
  const ArraySizes& sizes() const noexcept { return sizes_; }
  const ForceSettings& settings() const noexcept { return settings_; }

 private:
  const PinClass* class_;
  ArraySizes sizes_;
  ForceSettings settings_;
};

/// REQUIRES: first_mm < last_mm, step_mm > 0.
struct OffsetGrid {
  double first_mm = -2.5;
  double last_mm = 12.5;
  double step_mm = 0.5;

  std::vector<double> offsets_mm() const;  // first, first + step, ... up to last
};

inline constexpr OffsetGrid kThesisGrid{};  // the axes of thesis Fig. 2.10

/// All vectors have the same length.
struct ForceCurve {
  std::vector<double> offsets_mm;
  std::vector<double> force_n;
  std::vector<double> error_n;
};

/// Faster than point by point: each face position is computed once.
ForceCurve force_curve(const PinForce& force, const OffsetGrid& grid = kThesisGrid);

/// One for each class, to `kSameAngleDeg` of each pair's angle. Equal angles are computed once,
/// also those of different classes (GP(8,0) without two pins: 640 classes, 0.2 s).
std::vector<ForceCurve> force_curves(const std::vector<PinClass>& classes, const ArraySizes& sizes,
                                     const ForceSettings& settings, const OffsetGrid& grid);

}  // namespace hedgehog::model

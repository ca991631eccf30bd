// SPDX-License-Identifier: MIT
// The force on a pin, taken apart: what the other pins do does not depend on the shields, and what
// the shields do changes smoothly with their diameter. So a search over many diameters computes the
// first once and the second at a few diameters, and interpolates.
#pragma once

#include <vector>

#include "model/magnets/force_curve.h"

namespace hedgehog::design {

/// Offsets that a search looks at: a rest below is a pin that has fallen in, and pins have no room
/// to move as far as the end.
inline constexpr model::OffsetGrid kSearchGrid{-1.0, 3.0, 0.25};

/// One class of pins among pins and shields of one height on one sphere; shields of any diameter
/// from the smallest to the largest of `diameters_mm`.
class Pull {
 public:
  /// REQUIRES: `diameters_mm` ascending, not empty.
  Pull(const model::PinClass& pin_class, const model::ArraySizes& sizes,
       const std::vector<double>& diameters_mm);

  /// On the grid, with shields of that diameter whose strength is `strength` (1: as they are).
  std::vector<double> force_n(double diameter_mm, double strength) const;

 private:
  std::vector<double> from_pins_n_;
  std::vector<double> nodes_mm_;
  std::vector<double> weights_;
  /// For each node: the shields' force over the square of the diameter.
  std::vector<std::vector<double>> from_shields_;
};

/// Where the force first falls through `level_n`, from grid point `from` on, mm; NaN: nowhere.
/// Cubic between the grid points.
double falls_through(const std::vector<double>& force_n, double level_n,
                     std::size_t from = 0) noexcept;

}  // namespace hedgehog::design

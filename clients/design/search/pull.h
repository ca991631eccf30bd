// SPDX-License-Identifier: MIT
// The force on a pin in two parts: that of the other pins does not depend on the shields, and that
// of the shields changes smoothly with their diameter. So a search over many diameters computes the
// first once and the second at a few diameters, and interpolates.
#pragma once

#include <vector>

#include "model/magnets/force_curve.h"

namespace hedgehog::design {

/// Offsets in a search: with a rest below the first a pin has fallen in, and the last is beyond the
/// travel of the pins.
inline constexpr model::OffsetGrid kSearchGrid{-1.0, 3.0, 0.25};

/// One class of pins, with pins and shields of one height on one sphere; shields of any diameter
/// from the smallest to the largest of `diameters_mm`.
class Pull {
 public:
  /// REQUIRES: `diameters_mm` ascending, not empty.
  Pull(const model::PinClass& pin_class, const model::ArraySizes& sizes,
       const std::vector<double>& diameters_mm);

  /// On the grid, with shields of that diameter and the relative strength `strength` (1: nominal).
  std::vector<double> force_n(double diameter_mm, double strength) const;

 private:
  std::vector<double> from_pins_n_;
  std::vector<double> nodes_mm_;
  std::vector<double> weights_;
  /// For each node: the shields' force divided by the square of the diameter.
  std::vector<std::vector<double>> from_shields_;
};

/// The first downward crossing of `level_n`, from grid point `from` on, mm; NaN: none. Cubic
/// interpolation between the grid points.
double falls_through(const std::vector<double>& force_n, double level_n,
                     std::size_t from = 0) noexcept;

}  // namespace hedgehog::design

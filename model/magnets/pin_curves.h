// SPDX-License-Identifier: MIT
// Lookup tables of each pin's offset as a function of coil force, for the live twin. Built once at
// start-up; lookups do not allocate; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/magnets/magnet_array.h"

namespace hedgehog::model {

/// Range of a magnet's offset, 0 with its inner face on the sphere. Stops: shell below, casing
/// above (thesis section 2.4: 1.5 mm of travel).
struct PinTravel {
  double lowest_mm = 0.0;
  double highest_mm = 1.5;
};

/// Each pin is treated alone: the others stay at offset 0, as in the thesis' curves.
class PinCurves {
 public:
  /// REQUIRES: check_fit(arrangement, sizes) returns no error; lowest < highest.
  PinCurves(const Arrangement& arrangement, const ArraySizes& sizes, const PinTravel& travel = {});

  std::size_t size() const noexcept { return class_of_.size(); }
  /// Median of the pins' rest positions, mm: that of the typical pin, to which the device file's
  /// force slope refers (thesis section 3.1.1 measured one of the most common pins).
  double typical_rest_mm() const noexcept { return typical_rest_mm_; }
  /// Force on a pin at its rest position, N, for `typical_force_n` on the typical pin at its own: a
  /// pin nearer to the coil receives more (5 % at 0.5 mm).
  double force_at_rest_n(std::size_t pin, double typical_force_n) const noexcept {
    return typical_force_n * classes_[class_of_[pin]].share_at_rest;
  }
  /// Offset without any coil force, mm. A pin pulled inwards beyond its travel is on the shell; a
  /// push must first overcome that preload. REQUIRES: pin < size(), in the order of the
  /// arrangement's pins.
  double rest_mm(std::size_t pin) const noexcept { return offset_mm(pin, 0.0); }
  /// Offset under a coil force, mm. `coil_force_n`: outward, for this pin at the typical rest
  /// position (`pin_forces`); the curve includes its change with the offset. A force that expels
  /// the pin, or pulls it in entirely, saturates at the end of its travel; NaN counts as 0.
  double offset_mm(std::size_t pin, double coil_force_n) const noexcept;
  /// Displacement of the pin from rest by the force, mm; negative: inwards.
  double extension_mm(std::size_t pin, double coil_force_n) const noexcept {
    return offset_mm(pin, coil_force_n) - rest_mm(pin);
  }
  /// All pins. REQUIRES: both spans have size() elements.
  void extensions_mm(std::span<const double> coil_forces_n,
                     std::span<double> extensions_mm) const noexcept;

 private:
  /// Steps of 0.05 mm over the thesis' travel: linear interpolation is within 0.001 mm.
  static constexpr std::size_t kPoints = 31;
  /// Coil force that holds a pin at each of the points; non-decreasing.
  using HoldingForce = std::array<double, kPoints>;
  struct Class {
    HoldingForce holding{};
    /// Force at rest relative to that at the typical rest position.
    double share_at_rest = 1.0;
  };

  double median_rest_mm() const;

  PinTravel travel_;
  double typical_rest_mm_ = 0.0;
  std::vector<Class> classes_;
  std::vector<std::uint16_t> class_of_;
};

}  // namespace hedgehog::model

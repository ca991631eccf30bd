// SPDX-License-Identifier: MIT
// Tables of each pin's offset by coil force, built at start-up. Lookups: any thread, no allocation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/magnets/magnet_array.h"

namespace hedgehog::model {

/// Range of a magnet's offset, 0 with its inner face on the sphere (thesis section 2.4).
struct PinTravel {
  double lowest_mm = 0.0;   // stopped by the shell
  double highest_mm = 1.5;  // stopped by the casing
};

/// Each pin is treated alone: the others stay at offset 0, as in the thesis' curves.
class PinCurves {
 public:
  /// REQUIRES: check_fit(arrangement, sizes) returns no error; lowest < highest.
  PinCurves(const Arrangement& arrangement, const ArraySizes& sizes, const PinTravel& travel = {});

  std::size_t size() const noexcept { return class_of_.size(); }
  /// Median: that of the typical pin, to which the device file's force slope refers (thesis 3.1.1).
  double typical_rest_mm() const noexcept { return typical_rest_mm_; }
  /// For `typical_force_n` on the typical pin at rest: nearer pins receive more (5 % at 0.5 mm).
  double force_at_rest_n(std::size_t pin, double typical_force_n) const noexcept {
    return typical_force_n * classes_[class_of_[pin]].share_at_rest;
  }
  /// Offset without coil force; a pin pulled onto the shell has a preload that a push must
  /// overcome. REQUIRES: pin < size(), in the order of the arrangement's pins.
  double rest_mm(std::size_t pin) const noexcept { return offset_mm(pin, 0.0); }
  /// Offset under an outward coil force, given for this pin at the typical rest (`pin_forces`): its
  /// change with the offset is included. Saturates at the ends of the travel; NaN counts as 0.
  double offset_mm(std::size_t pin, double coil_force_n) const noexcept;
  /// Displacement from rest; negative: inwards.
  double extension_mm(std::size_t pin, double coil_force_n) const noexcept {
    return offset_mm(pin, coil_force_n) - rest_mm(pin);
  }
  /// All pins. REQUIRES: both spans have size() elements.
  void extensions_mm(std::span<const double> coil_forces_n,
                     std::span<double> extensions_mm) const noexcept;

 private:
  static constexpr std::size_t kPoints = 31;         // every 0.05 mm: interpolates within 0.001 mm
  using HoldingForce = std::array<double, kPoints>;  // of a pin at each point; non-decreasing
  struct Class {
    HoldingForce holding{};
    double share_at_rest = 1.0;  // force at rest relative to that at the typical rest
  };

  double median_rest_mm() const;

  PinTravel travel_;
  double typical_rest_mm_ = 0.0;
  std::vector<Class> classes_;
  std::vector<std::uint16_t> class_of_;
};

}  // namespace hedgehog::model

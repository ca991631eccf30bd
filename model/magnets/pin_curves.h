// SPDX-License-Identifier: MIT
// How far each pin of a ball is out, looked up: the live twin's curves. Made once at start-up;
// looking up allocates nothing and may be done in any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/magnets/magnet_array.h"

namespace hedgehog::model {

/// How far a magnet can move, from inner face on the sphere. The shell below and the casing above
/// stop it (thesis section 2.4: 1.5 mm of travel).
struct PinTravel {
  double lowest_mm = 0.0;
  double highest_mm = 1.5;
};

/// Each pin by itself: the others are taken to stay at offset 0, as in the thesis' curves.
class PinCurves {
 public:
  /// REQUIRES: check_fit(arrangement, sizes) has nothing to say; lowest < highest.
  PinCurves(const Arrangement& arrangement, const ArraySizes& sizes, const PinTravel& travel = {});

  std::size_t size() const noexcept { return class_of_.size(); }
  /// The median of the pins' rests, mm. A pin there is the typical one, whose force the device
  /// file's slope is (thesis section 3.1.1 measured on one of the commonest).
  double typical_rest_mm() const noexcept { return typical_rest_mm_; }
  /// What a pin at its own rest gets where the typical one at its rest gets `typical_force_n`, N:
  /// one that is nearer to the coil gets more (5 % at 0.5 mm).
  double force_at_rest_n(std::size_t pin, double typical_force_n) const noexcept {
    return typical_force_n * classes_[class_of_[pin]].share_at_rest;
  }
  /// Offset without any coil force, mm. A pin that the shields pull below its travel lies on the
  /// shell, and the first part of a push goes into that preload. REQUIRES: pin < size(), in the
  /// order of the arrangement's pins.
  double rest_mm(std::size_t pin) const noexcept { return offset_mm(pin, 0.0); }
  /// Offset under a coil force, mm. `coil_force_n`: outward, as it would be on this pin at the
  /// typical rest (`pin_forces`); that it is more below and less beyond is in the curve. A force
  /// that expels
  /// the pin, or pulls it in entirely, leaves it at the end of its travel; not a number counts as
  /// 0.
  double offset_mm(std::size_t pin, double coil_force_n) const noexcept;
  /// How far the force moves the pin from its rest, mm; negative: inwards.
  double extension_mm(std::size_t pin, double coil_force_n) const noexcept {
    return offset_mm(pin, coil_force_n) - rest_mm(pin);
  }
  /// All at once. REQUIRES: both are as long as size().
  void extensions_mm(std::span<const double> coil_forces_n,
                     std::span<double> extensions_mm) const noexcept;

 private:
  /// Steps of 0.05 mm over the thesis' travel: linear between them is within 0.001 mm.
  static constexpr std::size_t kPoints = 31;
  /// The coil force that holds a pin at each of the points; never falling.
  using HoldingForce = std::array<double, kPoints>;
  struct Class {
    HoldingForce holding{};
    /// Of the force at the typical rest.
    double share_at_rest = 1.0;
  };

  double median_rest_mm() const;

  PinTravel travel_;
  double typical_rest_mm_ = 0.0;
  std::vector<Class> classes_;
  std::vector<std::uint16_t> class_of_;
};

}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// Characterisation of a design: classes of pins with equal surroundings, each with its force curve,
// its rest and its extension by the coil (thesis sections 2.2 and 2.3).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"
#include "model/magnets/characterisation.h"

namespace hedgehog::design {

using model::Standing;
/// "rests", "pressed", "pushed out".
const char* name_of(Standing standing) noexcept;

struct ClassStudy {
  model::PinForce force;
  model::Characterisation character;
  /// With the design's coil force, which is constant while the pin moves; nullopt: pushed out
  /// without it.
  std::optional<model::Stroke> stroke;
  /// From zero crossing to crossing, as in thesis Table 2.1, mm; nullopt: no rest, or expelled.
  std::optional<double> crossings_mm;

  const model::PinClass& pins() const noexcept { return force.pin_class(); }
  Standing standing() const noexcept { return character.standing(); }
  /// Rest of a pin without current: 0 on the shell. nullopt: pushed out.
  std::optional<double> rest_mm() const noexcept { return character.standing_mm; }
  /// Extension by the coil force from there, mm; nullopt if it is pushed out or expelled.
  std::optional<double> extension_mm() const noexcept;
  std::size_t size() const noexcept { return pins().pins.size(); }
  /// The largest push against which a pin is held, N; nullopt if no force draws it back.
  std::optional<double> held_n() const noexcept;
  /// "60 pins".
  std::string name() const;
};

/// Characterises each class of pins among the magnets of `design`; forces refer to `classes`, which
/// must outlive them.
std::vector<ClassStudy> study_classes(const std::vector<model::PinClass>& classes,
                                      const Design& design,
                                      const model::OffsetGrid& grid = model::kThesisGrid);

/// The class of the typical pin: the one with the median rest, as in `model::PinCurves`. REQUIRES:
/// there is a class.
const ClassStudy& typical_of(const std::vector<ClassStudy>& classes);

/// The thesis' value for a class of `size` pins of this array (Table 2.1), mm.
std::optional<double> thesis_extension_mm(const std::string& array, std::size_t size) noexcept;

class Study {
 public:
  /// An error if magnets overlap.
  static Result<Study> of(const Design& design, const model::OffsetGrid& grid = model::kThesisGrid);

  const Design& design() const noexcept { return design_; }
  const model::Arrangement& arrangement() const noexcept { return arrangement_; }
  const std::vector<ClassStudy>& classes() const noexcept { return classes_; }
  /// The class of a pin; nullptr if there is no such pin.
  const ClassStudy* class_of(int pin) const noexcept;
  const ClassStudy& typical() const { return typical_of(classes_); }
  /// Pins of that standing, ascending.
  std::vector<int> pins_that(Standing standing) const;
  std::vector<int> unstable_pins() const { return pins_that(Standing::kPushedOut); }
  /// Pins that are pressed onto the shell, ascending: those whose force has a zero below it, or
  /// those without one, whose shields are too strong.
  std::vector<int> pressed_pins(bool with_zero) const;
  /// Every pin's force curve falls through zero (thesis section 2.2).
  bool stable() const noexcept;

 private:
  Study(Design design, model::Arrangement arrangement)
      : design_(std::move(design)), arrangement_(std::move(arrangement)) {}

  Design design_;
  model::Arrangement arrangement_;
  // Referred to by forces.
  std::shared_ptr<const std::vector<model::PinClass>> pin_classes_;
  std::vector<ClassStudy> classes_;
};

/// "0, 3-5, 8": ids ascending, consecutive ones as ranges.
std::string ids_text(const std::vector<int>& ids);

}  // namespace hedgehog::design

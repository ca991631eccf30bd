// SPDX-License-Identifier: MIT
// A design, characterised: the pins by classes of equal surroundings, each with its force curve,
// its rest and how far the coil moves it (thesis sections 2.2 and 2.3).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"
#include "model/magnets/characterisation.h"

namespace hedgehog::design {

/// What a pin does without current.
enum class Standing : std::uint8_t {
  kRests,
  /// No rest: pulled inwards already where its inner face is on the shell, which stops it.
  kPressed,
  /// No rest, and nothing draws it back.
  kPushedOut,
};
/// "rests", "pressed", "pushed out".
const char* name_of(Standing standing) noexcept;

struct ClassStudy {
  model::PinForce force;
  model::Characterisation character;
  /// With the design's coil force, mm; nothing when the pin does not rest or is expelled.
  std::optional<double> extension_mm;

  const model::PinClass& pins() const noexcept { return force.pin_class(); }
  Standing standing() const noexcept;
  std::size_t size() const noexcept { return pins().pins.size(); }
  /// The largest push against which a pin is held, N; nothing when nothing draws it back.
  std::optional<double> held_n() const noexcept;
  /// "60 pins".
  std::string name() const;
};

/// What the thesis prints for a class of `size` pins of this array (Table 2.1), mm.
std::optional<double> thesis_extension_mm(const std::string& array, std::size_t size) noexcept;

class Study {
 public:
  /// Complains when the magnets are in each other's way.
  static Result<Study> of(const Design& design, const model::OffsetGrid& grid = model::kThesisGrid);

  const Design& design() const noexcept { return design_; }
  const model::Arrangement& arrangement() const noexcept { return arrangement_; }
  const std::vector<ClassStudy>& classes() const noexcept { return classes_; }
  /// The class of a pin; nullptr when there is no such pin.
  const ClassStudy* class_of(int pin) const noexcept;
  /// The class that has the most pins.
  const ClassStudy& commonest() const noexcept;
  /// Pins of that standing, ascending.
  std::vector<int> pins_that(Standing standing) const;
  std::vector<int> unstable_pins() const { return pins_that(Standing::kPushedOut); }

 private:
  Study(Design design, model::Arrangement arrangement)
      : design_(std::move(design)), arrangement_(std::move(arrangement)) {}

  Design design_;
  model::Arrangement arrangement_;
  // Forces point into it.
  std::shared_ptr<const std::vector<model::PinClass>> pin_classes_;
  std::vector<ClassStudy> classes_;
};

/// 0, 3-5, 8: ids ascending, runs drawn together.
std::string ids_text(const std::vector<int>& ids);

}  // namespace hedgehog::design

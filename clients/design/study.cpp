// SPDX-License-Identifier: MIT
#include "clients/design/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace hedgehog::design {
namespace {

struct Printed {
  std::string_view array;
  std::size_t size;
  double extension_mm;
};

// Thesis Table 2.1. It does not name the classes; they are assigned in the order of their
// extension.
constexpr std::array kTable21{Printed{"cD", 12, 0.8},  Printed{"cD", 30, 3.5},
                              Printed{"wD", 12, 0.2},  Printed{"wD", 60, 0.6},
                              Printed{"tkD", 12, 0.1}, Printed{"tkD", 60, 0.6},
                              Printed{"tkD", 20, 0.7}};

/// This number of pairs of a pin's class and an angle takes half a minute to compute.
constexpr std::size_t kMaxPairs = 400'000;
constexpr double kGravityMS2 = 9.81;

std::optional<Problem> too_many(const Design& design, const std::vector<model::PinClass>& classes) {
  std::size_t pairs = 0;
  for (const model::PinClass& one : classes) pairs += one.to_pins.size() + one.to_shields.size();
  if (pairs <= kMaxPairs) return {};
  return Problem{kBadData, to_text(design) + ": " + std::to_string(classes.size()) +
                               " of its pins differ from each other, which would take minutes to "
                               "compute; remove magnets in a pattern that keeps the symmetry"};
}

/// An error for magnets that cannot carry a pin: the results would be meaningless.
std::optional<Problem> too_weak(const Design& design, const std::vector<ClassStudy>& classes) {
  double strongest_n = 0.0;
  for (const ClassStudy& one : classes)
    for (const double force_n : one.character.curve.force_n)
      strongest_n = std::max(strongest_n, std::abs(force_n));
  const double weight_n = 1e-3 * model::mass_g(design.sizes().pin) * kGravityMS2;
  if (strongest_n >= weight_n) return {};
  return Problem{kBadData, to_text(design) +
                               ": the magnets are too far apart to hold anything: the weight of a "
                               "pin, " +
                               fmt::format("{:.1g} N, is more than any force on it ({:.1g} N)",
                                           weight_n, strongest_n)};
}

}  // namespace

const char* name_of(Standing standing) noexcept {
  switch (standing) {
    case Standing::kRests:
      return "rests";
    case Standing::kPressed:
      return "pressed";
    case Standing::kPushedOut:
      break;
  }
  return "pushed out";
}

std::optional<double> ClassStudy::extension_mm() const noexcept {
  return stroke && !stroke->expelled ? std::optional(stroke->extension_mm) : std::nullopt;
}

std::optional<double> ClassStudy::held_n() const noexcept {
  if (standing() == Standing::kPushedOut) return {};
  // A pin is never further in than the shell.
  return character.minimum_mm < 0.0 ? -character.shell_n : -character.minimum_n;
}

std::string ClassStudy::name() const {
  return std::to_string(size()) + (size() == 1 ? " pin" : " pins");
}

std::optional<double> thesis_extension_mm(const std::string& array, std::size_t size) noexcept {
  for (const Printed& printed : kTable21)
    if (printed.array == array && printed.size == size) return printed.extension_mm;
  return {};
}

std::vector<ClassStudy> study_classes(const std::vector<model::PinClass>& classes,
                                      const Design& design, const model::OffsetGrid& grid) {
  std::vector<ClassStudy> studied;
  for (const model::PinClass& pin_class : classes) {
    const model::PinForce force(pin_class, design.sizes(), design.settings);
    ClassStudy one{force, model::characterise(force, grid), {}, {}};
    one.stroke = model::stroke(force, one.character, model::constant_push(design.coil_force_n));
    one.crossings_mm = model::extension_mm(force, one.character, design.coil_force_n);
    studied.push_back(std::move(one));
  }
  return studied;
}

const ClassStudy& typical_of(const std::vector<ClassStudy>& classes) {
  const auto before = [](const ClassStudy* a, const ClassStudy* b) {
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    return a->rest_mm().value_or(kNowhere) < b->rest_mm().value_or(kNowhere);
  };
  std::vector<const ClassStudy*> of_pins;
  for (const ClassStudy& one : classes) of_pins.insert(of_pins.end(), one.size(), &one);
  const auto middle = of_pins.begin() + static_cast<std::ptrdiff_t>((of_pins.size() - 1) / 2);
  std::nth_element(of_pins.begin(), middle, of_pins.end(), before);
  return **middle;
}

Result<Study> Study::of(const Design& design, const model::OffsetGrid& grid) {
  auto arrangement = buildable_arrangement(design);
  if (!arrangement) return arrangement.error();
  Study study(design, std::move(*arrangement));
  study.pin_classes_ = std::make_shared<const std::vector<model::PinClass>>(
      model::symmetry_classes(study.arrangement_));
  if (const auto problem = too_many(design, *study.pin_classes_)) return *problem;
  study.classes_ = study_classes(*study.pin_classes_, design, grid);
  if (const auto problem = too_weak(design, study.classes_)) return *problem;
  return study;
}

const ClassStudy* Study::class_of(int pin) const noexcept {
  const auto found = std::find_if(classes_.begin(), classes_.end(), [pin](const ClassStudy& one) {
    return std::binary_search(one.pins().pins.begin(), one.pins().pins.end(), pin);
  });
  return found == classes_.end() ? nullptr : &*found;
}

std::vector<int> Study::pins_that(Standing standing) const {
  std::vector<int> ids;
  for (const ClassStudy& one : classes_)
    if (one.standing() == standing)
      ids.insert(ids.end(), one.pins().pins.begin(), one.pins().pins.end());
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<int> Study::pressed_pins(bool with_zero) const {
  std::vector<int> ids = pins_that(Standing::kPressed);
  std::erase_if(ids, [&](int pin) { return class_of(pin)->character.stable() != with_zero; });
  return ids;
}

bool Study::stable() const noexcept {
  return std::all_of(
      classes_.begin(), classes_.end(),
      [](const ClassStudy& one) { return one.character.stable(); });
}

std::string ids_text(const std::vector<int>& ids) {
  std::string text;
  for (std::size_t i = 0; i < ids.size();) {
    std::size_t last = i;
    while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1) ++last;
    if (!text.empty()) text += ", ";
    text += std::to_string(ids[i]);
    if (last > i) text += (last == i + 1 ? ", " : "-") + std::to_string(ids[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
#include "clients/design/study.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace hedgehog::design {
namespace {

struct Printed {
  std::string_view array;
  std::size_t size;
  double extension_mm;
};

// Thesis Table 2.1. It names no classes; ordered by how far they move they are these.
constexpr std::array kTable21{Printed{"cD", 12, 0.8},  Printed{"cD", 30, 3.5},
                              Printed{"wD", 12, 0.2},  Printed{"wD", 60, 0.6},
                              Printed{"tkD", 12, 0.1}, Printed{"tkD", 60, 0.6},
                              Printed{"tkD", 20, 0.7}};

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

Standing ClassStudy::standing() const noexcept {
  if (character.stable()) return Standing::kRests;
  return force.at(0.0).force_n < 0.0 ? Standing::kPressed : Standing::kPushedOut;
}

std::optional<double> ClassStudy::held_n() const noexcept {
  if (standing() == Standing::kPushedOut) return {};
  // It never is further in than the shell.
  return character.minimum_mm < 0.0 ? -force.at(0.0).force_n : -character.minimum_n;
}

std::string ClassStudy::name() const {
  return std::to_string(size()) + (size() == 1 ? " pin" : " pins");
}

std::optional<double> thesis_extension_mm(const std::string& array, std::size_t size) noexcept {
  for (const Printed& printed : kTable21)
    if (printed.array == array && printed.size == size) return printed.extension_mm;
  return {};
}

Result<Study> Study::of(const Design& design, const model::OffsetGrid& grid) {
  auto arrangement = buildable_arrangement(design);
  if (!arrangement) return arrangement.error();
  Study study(design, std::move(*arrangement));
  study.pin_classes_ = std::make_shared<const std::vector<model::PinClass>>(
      model::symmetry_classes(study.arrangement_));
  for (const model::PinClass& pin_class : *study.pin_classes_) {
    const model::PinForce force(pin_class, design.sizes(), design.settings);
    ClassStudy one{force, model::characterise(force, grid), {}};
    one.extension_mm = model::extension_mm(force, one.character, design.coil_force_n);
    study.classes_.push_back(std::move(one));
  }
  return study;
}

const ClassStudy* Study::class_of(int pin) const noexcept {
  const auto found = std::find_if(classes_.begin(), classes_.end(), [pin](const ClassStudy& one) {
    return std::binary_search(one.pins().pins.begin(), one.pins().pins.end(), pin);
  });
  return found == classes_.end() ? nullptr : &*found;
}

const ClassStudy& Study::commonest() const noexcept {
  return *std::max_element(
      classes_.begin(), classes_.end(),
      [](const ClassStudy& a, const ClassStudy& b) { return a.size() < b.size(); });
}

std::vector<int> Study::pins_that(Standing standing) const {
  std::vector<int> ids;
  for (const ClassStudy& one : classes_)
    if (one.standing() == standing)
      ids.insert(ids.end(), one.pins().pins.begin(), one.pins().pins.end());
  std::sort(ids.begin(), ids.end());
  return ids;
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

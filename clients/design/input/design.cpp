// SPDX-License-Identifier: MIT
#include "clients/design/input/design.h"

#include <algorithm>
#include <array>
#include <regex>

#include "base/keys/value.h"
#include "base/spelling.h"
#include "clients/design/input/positions_file.h"

namespace hedgehog::design {
namespace {

using model::Arrangement;
using model::MagnetSite;

constexpr std::size_t kFanPins = 6;  // the lowest and its five neighbours

Problem unknown(const std::string& name) {
  static constexpr std::array kNames{"D",     "tI",    "cD",     "wD",      "tkD",
                                     "cD-36", "wD-66", "tkD-86", "GP(2,2)", "GP(4,1)"};
  const auto distance = [wanted = base::lower_case(name)](const char* known) {
    return base::edits_between(wanted, base::lower_case(known));
  };
  const auto nearest =
      std::min_element(kNames.begin(), kNames.end(),
                       [&](const char* a, const char* b) { return distance(a) < distance(b); });
  std::string sentence = "unknown array '" + keys::printable(name) + "'";
  // A name that differs by more than half is not similar.
  if (2 * distance(*nearest) <= std::max<std::size_t>(name.size(), 2)) {
    sentence += "; did you mean '" + std::string(*nearest) + "'?";
  } else {
    sentence +=
        "; there are cD, wD, tkD, D, tI and GP(m,n) with m + n up to 8, and tkD-86, the same with "
        "the "
        "fan's opening";
  }
  return {kUsage, sentence};
}

/// The ids of the lowest pin and its five neighbours.
std::vector<int> pins_at_the_bottom(const Arrangement& array) {
  std::vector<MagnetSite> pins = array.pins;
  std::sort(pins.begin(), pins.end(),
            [](const MagnetSite& a, const MagnetSite& b) { return a.direction.z < b.direction.z; });
  std::vector<int> ids;
  for (std::size_t i = 0; i < kFanPins; ++i) ids.push_back(pins[i].id);
  return ids;
}

/// The shields at a corner of `min_faces` or more of the faces of these pins: a shield belongs to
/// the three pins that are nearest to it.
std::vector<int> shields_touching(const Arrangement& array, const std::vector<int>& removed,
                                  int min_faces) {
  std::vector<int> ids;
  for (const MagnetSite& shield : array.shields) {
    std::vector<MagnetSite> pins = array.pins;
    std::partial_sort(
        pins.begin(), pins.begin() + 3, pins.end(),
        [&](const MagnetSite& a, const MagnetSite& b) {
          return model::dot(a.direction, shield.direction) >
                 model::dot(b.direction, shield.direction);
        });
    const auto touched = std::count_if(pins.begin(), pins.begin() + 3, [&](const MagnetSite& pin) {
      return std::find(removed.begin(), removed.end(), pin.id) != removed.end();
    });
    if (touched >= min_faces) ids.push_back(shield.id);
  }
  return ids;
}

Result<Arrangement> named(const std::string& name, const std::string& as_typed) {
  auto found = model::arrangement_named(name);
  if (found) return *found;
  static const std::regex kGoldberg(R"(GP\(\d+,\d+\))");
  // A Goldberg polyhedron that is too fine has its own error message.
  if (std::regex_match(name, kGoldberg)) return Problem{kUsage, found.error().message};
  return unknown(as_typed);
}

}  // namespace

Result<Arrangement> find_arrangement(const std::string& name) {
  static const std::regex kOpened(R"(([^-]+)-(\d{1,4})(?:-(5|10|20))?)");
  std::smatch parts;
  if (!std::regex_match(name, parts, kOpened)) return named(name, name);
  auto whole = named(parts[1], name);
  if (!whole) return whole.error();
  if (whole->pins.size() - kFanPins != std::stoul(parts[2])) {
    return Problem{kUsage, "unknown array '" + name + "'; did you mean '" + parts[1].str() + "-" +
                               std::to_string(whole->pins.size() - kFanPins) + "'?"};
  }
  // The ball of the thesis has its own pin numbers.
  if (auto known = model::arrangement_named(name)) return *known;
  const int min_faces = parts[3] == "5" ? 3 : parts[3] == "20" ? 1 : 2;
  const std::vector<int> pins = pins_at_the_bottom(*whole);
  const std::vector<int> shields = shields_touching(*whole, pins, min_faces);
  auto opened = model::without(std::move(*whole), pins, shields);
  if (!opened) return Problem{kInternal, opened.error().message};
  opened->name = name;
  // Renumbered, so that the ids have no gaps.
  for (auto* sites : {&opened->pins, &opened->shields})
    for (std::size_t i = 0; i < sites->size(); ++i) (*sites)[i].id = static_cast<int>(i);
  return *opened;
}

Result<Arrangement> arrangement_of(const Design& design) {
  auto whole =
      design.positions.empty() ? find_arrangement(design.array) : read_positions(design.positions);
  if (!whole) return whole.error();
  if (design.removed_pins.empty() && design.removed_shields.empty()) return *whole;
  auto left = model::without(std::move(*whole), design.removed_pins, design.removed_shields);
  if (!left) return Problem{kUsage, left.error().message};
  if (left->pins.empty()) return Problem{kUsage, "no pin is left"};
  return *left;
}

Result<Arrangement> buildable_arrangement(const Design& design) {
  if (const auto problem = model::problem_with(design.sizes())) return Problem{kUsage, *problem};
  auto array = arrangement_of(design);
  if (!array) return array.error();
  if (const auto problem = model::check_fit(*array, design.sizes()))
    return Problem{kBadData, array->name + ": " + problem->message};
  return *array;
}

bool has_thesis_magnets(const Design& design) noexcept {
  const Design thesis;
  return design.whole() && design.magnet == thesis.magnet && design.shield == thesis.shield &&
         design.sphere_mm == thesis.sphere_mm && design.remanence_t == thesis.remanence_t;
}

bool is_of_the_thesis(const Design& design) noexcept {
  return has_thesis_magnets(design) && design.coil_force_n == Design{}.coil_force_n &&
         design.settings.model != model::ForceModel::kDipole;
}

std::string to_text(const Design& design) {
  std::string text = (design.positions.empty() ? design.array : design.positions) + ", pins " +
                     to_text(design.magnet) + ", shields " + to_text(design.shield) + ", sphere " +
                     to_text(design.sphere_mm) + " mm";
  const auto removed = [&text](std::size_t count, const char* what) {
    if (count > 0)
      text += ", " + std::to_string(count) + " " + what + (count == 1 ? "" : "s") + " removed";
  };
  removed(design.removed_pins.size(), "pin");
  removed(design.removed_shields.size(), "shield");
  return text;
}

}  // namespace hedgehog::design

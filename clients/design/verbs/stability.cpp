// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "clients/common/text.h"
#include "clients/design/output/table.h"
#include "clients/design/study.h"
#include "clients/design/verbs/verbs.h"
#include "model/magnets/equilibrium.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

/// The class that the smallest push expels; one that needs no push comes first.
const ClassStudy& weakest_of(const Study& study) {
  return *std::min_element(
      study.classes().begin(), study.classes().end(),
      [](const ClassStudy& a, const ClassStudy& b) { return a.held_n() < b.held_n(); });
}

std::string state_of(const ClassStudy& one) {
  switch (one.standing()) {
    case Standing::kRests:
      return "stable";
    case Standing::kPressed:
      return "on the shell, " + fixed(one.character.preload_n(), 2) + " N";
    case Standing::kPushedOut:
      break;
  }
  return "UNSTABLE";
}

/// "0.19" or "0.19 to 0.21": preload of the pins on the shell, N.
std::string preloads_text(const Study& study, bool stable) {
  double lowest = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const ClassStudy& one : study.classes()) {
    if (one.standing() != Standing::kPressed || one.character.stable() != stable) continue;
    lowest = std::min(lowest, one.character.preload_n());
    most = std::max(most, one.character.preload_n());
  }
  return fixed(lowest, 2) + (most - lowest < 0.005 ? "" : " to " + fixed(most, 2));
}

Table table_of(const Study& study) {
  Table table({{"class", "class_size"},
               {"rest mm", "rest_mm"},
               {"N/mm", "stiffness_n_mm"},
               {"held up to N", "held_n"},
               {"moves mm", "extension_mm"},
               {"", "state", true},
               {"pins", "pins", true}});
  for (const ClassStudy& one : study.classes()) {
    const bool stable = one.character.stable();
    table.add({std::to_string(one.size()), fixed(or_none(one.rest_mm()), 3),
               stable ? fixed(one.character.stiffness_n_mm, 3) : "none",
               fixed(or_none(one.held_n()), 3), fixed(or_none(one.extension_mm()), 3),
               state_of(one), ids_text(one.pins().pins)});
  }
  return table;
}

Json json_of(const Study& study,
             const std::optional<model::MagnetResult<model::Equilibrium>>& together) {
  const std::vector<int> unstable = study.unstable_pins();
  const std::vector<int> pressed = study.pins_that(Standing::kPressed);
  const ClassStudy& weakest = weakest_of(study);
  const ClassStudy& typical = study.typical();
  Json root{{"array", study.arrangement().name},
            {"pins", study.arrangement().pins.size()},
            {"shields", study.arrangement().shields.size()},
            {"coil_force_n", study.design().coil_force_n},
            {"stable", study.stable()},
            {"unstable", unstable},
            {"pressed", pressed},
            {"weakest",
             {{"pin", weakest.pins().pins.front()},
              {"held_n", or_none(weakest.held_n())},
              {"extension_mm", or_none(weakest.extension_mm())}}},
            {"typical",
             {{"pin", typical.pins().pins.front()},
              {"rest_mm", or_none(typical.rest_mm())},
              {"extension_mm", or_none(typical.extension_mm())}}},
            {"classes", Json::array()}};
  for (const ClassStudy& one : study.classes()) {
    root["classes"].push_back({{"size", one.size()},
                               {"pins", one.pins().pins},
                               {"stable", one.character.stable()},
                               {"state", name_of(one.standing())},
                               {"rest_mm", or_none(one.rest_mm())},
                               {"zero_mm", or_none(one.character.rest_mm)},
                               {"preload_n", one.character.preload_n()},
                               {"stiffness_n_mm", one.character.stiffness_n_mm},
                               {"held_n", or_none(one.held_n())},
                               {"minimum_n", one.character.minimum_n},
                               {"minimum_mm", one.character.minimum_mm},
                               {"extension_mm", or_none(one.extension_mm())}});
  }
  if (!together) return root;
  if (*together) {
    root["together"] = {{"stable", (*together)->stable()},
                        {"offsets_mm", (*together)->offsets_mm},
                        {"softest_n_mm", (*together)->stiffness_n_mm.front()},
                        {"stiffest_n_mm", (*together)->stiffness_n_mm.back()}};
  } else {
    root["together"] = {{"stable", false}, {"reason", together->error().message}};
  }
  return root;
}

void print_text(const Study& study,
                const std::optional<model::MagnetResult<model::Equilibrium>>& together,
                std::ostream& out) {
  const std::vector<int> unstable = study.unstable_pins();
  const std::size_t count = study.arrangement().pins.size();
  out << "  " << to_text(study.design()) << "; " << study.arrangement().shields.size()
      << " shields\n";
  if (study.stable()) {
    const ClassStudy& weakest = weakest_of(study);
    out << "  all " << count << " pins stable; weakest: pin " << weakest.pins().pins.front()
        << ", held up to " << fixed(or_none(weakest.held_n()), 2) << " N";
    out << (weakest.extension_mm() ? ", " + fixed(*weakest.extension_mm(), 2) + " mm"
                                   : ", expelled")
        << " at " << to_text(study.design().coil_force_n) << " N\n";
  }
  if (!unstable.empty()) {
    out << "  " << unstable.size() << " of " << count
        << " pins UNSTABLE, nothing draws them back: " << ids_text(unstable) << "\n";
  }
  for (const bool stable : {true, false}) {
    const std::vector<int> pressed = study.pressed_pins(stable);
    if (pressed.empty()) continue;
    out << client::wrapped(std::to_string(pressed.size()) + " of " + std::to_string(count) +
                               " pins pressed onto the shell with " + preloads_text(study, stable) +
                               " N" +
                               (stable ? ", below which no push moves them: "
                                       : " and without a rest, the shields are too strong: ") +
                               ids_text(pressed),
                           78, 2);
  }
  out << "\n";
  out << table_of(study).text();
  if (!together) return;
  if (!*together) {
    out << "\n  all pins free at once: " << together->error().message << "\n";
    return;
  }
  const auto [low, high] =
      std::minmax_element((*together)->offsets_mm.begin(), (*together)->offsets_mm.end());
  out << "\n  all pins free at once: " << ((*together)->stable() ? "stable" : "UNSTABLE")
      << ", at rest from " << fixed(*low, 3) << " to " << fixed(*high, 3) << " mm, stiffness "
      << fixed((*together)->stiffness_n_mm.front(), 3) << " to "
      << fixed((*together)->stiffness_n_mm.back(), 2) << " N/mm\n";
}

}  // namespace

Result<void> run_stability(const StabilityOptions& options, const Screen& screen) {
  const auto design = design_from(options.design);
  if (!design) return design.error();
  const auto study = Study::of(*design);
  if (!study) return study.error();
  std::optional<model::MagnetResult<model::Equilibrium>> together;
  if (options.together)
    together = model::find_equilibrium(study->arrangement(), design->sizes(), design->settings);
  switch (screen.format) {
    case Format::kJson:
      screen.out << json_of(*study, together).dump(2) << "\n";
      break;
    case Format::kCsv:
      screen.out << table_of(*study).csv();
      break;
    case Format::kText:
      print_text(*study, together, screen.out);
      break;
  }
  return {};
}

}  // namespace hedgehog::design

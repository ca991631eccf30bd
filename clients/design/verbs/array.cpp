// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>

#include "clients/design/ball_numbers.h"
#include "clients/design/input/design_file.h"
#include "clients/design/input/positions_file.h"
#include "clients/design/output/table.h"
#include "clients/design/output/tool.h"
#include "clients/design/study.h"
#include "clients/design/verbs/array_json.h"
#include "clients/design/verbs/verbs.h"
#include "model/magnets/symmetry_classes.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;
using model::MagnetSite;

Json sites_json(const std::vector<MagnetSite>& sites) {
  Json list = Json::array();
  for (const MagnetSite& site : sites) {
    list.push_back(
        {{"id", site.id}, {"direction", {site.direction.x, site.direction.y, site.direction.z}}});
  }
  return list;
}

double nearest_deg(const std::vector<model::AngleCount>& angles) {
  return angles.empty() ? or_none({}) : angles.front().angle_deg;
}

std::string magnet_name(model::MagnetKind kind, int id) {
  return std::string(model::name_of(kind)) + " " + std::to_string(id);
}

}  // namespace

std::string array_json(const Design& design, const model::Arrangement& array) {
  const BallMass mass = mass_of(array, design);
  Json root{{"array", array.name},
            {"pins", array.pins.size()},
            {"shields", array.shields.size()},
            {"sphere_mm", design.sphere_mm},
            {"outer_diameter_mm", outer_diameter_mm(design)},
            {"mass_g", mass.total_g()},
            {"casing_g", mass.casing_g},
            {"wall_mm", thinnest_wall(casing_of(design, array), array).mm}};
  for (const model::MagnetGap& gap : model::smallest_gaps(array, design.sizes())) {
    root["gaps"].push_back(
        {{"between", {magnet_name(gap.kind_a, gap.id_a), magnet_name(gap.kind_b, gap.id_b)}},
         {"angle_deg", gap.angle_deg},
         {"gap_mm", gap.gap_mm}});
  }
  for (const model::PinClass& one : model::symmetry_classes(array)) {
    root["classes"].push_back({{"size", one.pins.size()},
                               {"pins", one.pins},
                               {"nearest_shield_deg", nearest_deg(one.to_shields)},
                               {"nearest_pin_deg", nearest_deg(one.to_pins)}});
  }
  root["positions"] = {{"pins", sites_json(array.pins)}, {"shields", sites_json(array.shields)}};
  return root.dump(2) + "\n";
}

namespace {

void print_text(const Design& design, const model::Arrangement& array, std::ostream& out) {
  const BallMass mass = mass_of(array, design);
  out << "  " << to_text(design) << "\n"
      << "  " << array.pins.size() << " pins, " << array.shields.size() << " shields, outside "
      << fixed(outer_diameter_mm(design), 1) << " mm across, " << fixed(mass.total_g() / 1000.0, 2)
      << " kg,\n  of it the casing " << fixed(mass.casing_g / 1000.0, 2)
      << " kg when printed solid in PLA\n\n";
  Table gaps({{"nearest", "nearest", true},
              {"", "other", true},
              {"angle deg", "angle_deg"},
              {"gap mm", "gap_mm"}});
  for (const model::MagnetGap& gap : model::smallest_gaps(array, design.sizes())) {
    gaps.add({magnet_name(gap.kind_a, gap.id_a), magnet_name(gap.kind_b, gap.id_b),
              fixed(gap.angle_deg, 4), fixed(gap.gap_mm, 2)});
  }
  Table classes({{"class", "class", true},
                 {"nearest shield deg", "nearest_shield_deg"},
                 {"nearest pin deg", "nearest_pin_deg"},
                 {"pins", "pins", true}});
  for (const model::PinClass& one : model::symmetry_classes(array)) {
    classes.add({std::to_string(one.pins.size()) + (one.pins.size() == 1 ? " pin" : " pins"),
                 fixed(nearest_deg(one.to_shields), 4), fixed(nearest_deg(one.to_pins), 4),
                 ids_text(one.pins)});
  }
  out << gaps.text() << "\n" << classes.text();
}

}  // namespace

Result<void> run_array(const ArrayOptions& options, const Screen& screen) {
  const auto design = design_from(options.design);
  if (!design) return design.error();
  const auto array = buildable_arrangement(*design);
  if (!array) return array.error();
  if (!options.save.empty()) {
    const auto saved = write_file(options.save, design_text(*design));
    if (!saved) return saved.error();
  }
  switch (screen.format) {
    case Format::kJson:
      screen.out << array_json(*design, *array);
      break;
    case Format::kCsv:
      screen.out << positions_csv(*array, design->sizes());
      break;
    case Format::kText:
      print_text(*design, *array, screen.out);
      break;
  }
  return {};
}

}  // namespace hedgehog::design

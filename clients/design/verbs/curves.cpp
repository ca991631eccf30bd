// SPDX-License-Identifier: MIT
#include "clients/design/verbs/curves.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "clients/design/output/table.h"
#include "clients/design/verbs/verbs.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

Json class_json(const ClassStudy& one, const model::ForceCurve& curve) {
  const model::Characterisation& character = one.character;
  return {{"size", one.size()},
          {"pins", one.pins().pins},
          {"stable", character.stable()},
          {"state", name_of(one.standing())},
          {"rest_mm", or_none(one.rest_mm())},
          {"preload_n", character.preload_n()},
          {"extension_mm", or_none(one.extension_mm())},
          {"zero_mm", or_none(character.rest_mm)},
          {"crossings_mm", or_none(one.crossings_mm)},
          {"unstable_mm", or_none(character.unstable_mm)},
          {"stiffness_n_mm", character.stiffness_n_mm},
          {"minimum_n", character.minimum_n},
          {"minimum_mm", character.minimum_mm},
          {"offsets_mm", curve.offsets_mm},
          {"force_n", curve.force_n},
          {"error_n", curve.error_n}};
}

Json study_json(const Study& study, const model::OffsetGrid& grid) {
  const Design& design = study.design();
  Json root{{"array", study.arrangement().name},
            {"magnet", to_text(design.magnet)},
            {"shield", to_text(design.shield)},
            {"sphere_mm", design.sphere_mm},
            {"model", model::name_of(design.settings.model)},
            {"accuracy", design.settings.accuracy},
            {"coil_force_n", design.coil_force_n},
            {"classes", Json::array()}};
  for (const ClassStudy& one : study.classes())
    root["classes"].push_back(class_json(one, model::force_curve(one.force, grid)));
  return root;
}

std::string csv_of(const std::vector<Study>& studies, const model::OffsetGrid& grid) {
  Table table({{"array", "array", true},
               {"shield", "shield", true},
               {"class", "class_size"},
               {"offset mm", "offset_mm"},
               {"force N", "force_n"}});
  for (const Study& study : studies) {
    for (const ClassStudy& one : study.classes()) {
      const model::ForceCurve curve = model::force_curve(one.force, grid);
      for (std::size_t i = 0; i < curve.offsets_mm.size(); ++i) {
        table.add({study.arrangement().name, to_text(study.design().shield),
                   std::to_string(one.size()), fixed(curve.offsets_mm[i], 4),
                   fixed(curve.force_n[i], 7)});
      }
    }
  }
  return table.csv();
}

std::string text_of(const std::vector<Study>& studies) {
  Table table({{"array", "array", true},
               {"shield", "shield", true},
               {"class", "class", true},
               {"F(0) N", "force_n"},
               {"least N", "minimum_n"},
               {"at mm", "minimum_mm"},
               {"zero mm", "zero_mm"},
               {"N/mm", "stiffness_n_mm"},
               {"rest mm", "rest_mm"},
               {"moves mm", "extension_mm"}});
  const auto shown = [](const std::optional<double>& number) { return fixed(or_none(number), 3); };
  for (const Study& study : studies) {
    for (const ClassStudy& one : study.classes()) {
      const model::Characterisation& c = one.character;
      table.add({study.arrangement().name, to_text(study.design().shield), one.name(),
                 fixed(one.force.at(0.0).force_n, 4), fixed(c.minimum_n, 4), fixed(c.minimum_mm, 2),
                 shown(c.rest_mm), c.stable() ? fixed(c.stiffness_n_mm, 3) : "none",
                 shown(one.rest_mm()), shown(one.extension_mm())});
    }
  }
  return table.text();
}

/// Text of a class in the key.
std::string legend(const ClassStudy& one, const std::string& array, bool few) {
  std::string text = one.name();
  if (!few)
    text += " (" + std::to_string(one.pins().pins.front()) + (one.size() > 1 ? ", …)" : ")");
  if (!one.character.stable()) return text + ": no zero";
  text += ": zero at " + fixed(*one.character.rest_mm, 2) + ", ";
  text += one.crossings_mm ? fixed(*one.crossings_mm, 2) + " mm more when pushed" : "not held";
  const auto printed = thesis_extension_mm(array, one.size());
  return printed ? text + " (thesis " + fixed(*printed, 1) + ")" : text;
}

/// The rest of a tkD class according to the thesis (section 3.1.4), mm.
constexpr double kThesisRestMm = 0.45;

Panel panel_of(const Study& study, const model::OffsetGrid& grid) {
  const Design& design = study.design();
  const std::string& array = study.arrangement().name;
  const bool as_in_thesis = is_of_the_thesis(design);
  Panel panel;
  panel.title = array + ", " + to_text(design.shield.diameter_mm) + " mm shields";
  panel.x_label = "offset of the pin (mm)";
  panel.y_label = "force on the pin, outwards (N)";
  panel.x_range = {grid.first_mm, grid.last_mm};
  Series marks{"thesis' extension, Table 2.1", {}, Series::Style::kMarks, 6};
  Series rest{"thesis' rest 0.45 mm, section 3.1.4", {}, Series::Style::kMarks, 4};
  int colour = 0;
  double lowest = 0.0;
  double highest = 0.0;
  const model::OffsetGrid fine{grid.first_mm, grid.last_mm, (grid.last_mm - grid.first_mm) / 120.0};
  for (const ClassStudy& one : study.classes()) {
    Series series{legend(one, as_in_thesis ? array : "", study.classes().size() <= 3),
                  {},
                  Series::Style::kLine,
                  colour++};
    const model::ForceCurve curve = model::force_curve(one.force, fine);
    for (std::size_t i = 0; i < curve.offsets_mm.size(); ++i) {
      series.points.push_back({curve.offsets_mm[i], curve.force_n[i]});
      lowest = std::min(lowest, curve.force_n[i]);
      highest = std::max(highest, curve.force_n[i]);
    }
    panel.series.push_back(std::move(series));
    const auto printed = thesis_extension_mm(array, one.size());
    if (as_in_thesis && printed && one.character.stable()) {
      marks.points.push_back({*one.character.rest_mm + *printed, -design.coil_force_n});
      if (array == "tkD" && one.size() == 60) rest.points.push_back({kThesisRestMm, 0.0});
    }
  }
  panel.series.push_back(
      {"the coil's " + to_text(design.coil_force_n) + " N",
       {{grid.first_mm, -design.coil_force_n}, {grid.last_mm, -design.coil_force_n}},
       Series::Style::kDashed,
       7});
  if (!marks.points.empty()) panel.series.push_back(std::move(marks));
  if (!rest.points.empty()) panel.series.push_back(std::move(rest));
  return panel;
}

/// nullopt if nothing is given; equal ends for "own".
Result<std::optional<Point>> forces_of(const std::string& typed) {
  if (typed.empty()) return std::optional<Point>();
  if (typed == "own") return std::optional(Point{});
  const Problem problem{kUsage,
                        "--forces: '" + typed + "' is neither own nor a range such as -2..6"};
  const std::size_t dots = typed.find("..");
  if (dots == std::string::npos) return problem;
  const auto end = [](const std::string& text) {
    return parse_range(text, 1.0, -1000.0, 1000.0, "--forces");
  };
  const auto first = end(typed.substr(0, dots));
  const auto last = end(typed.substr(dots + 2));
  if (!first) return first.error();
  if (!last) return last.error();
  if (first->size() != 1 || last->size() != 1 || first->front() >= last->front()) return problem;
  return std::optional(Point{first->front(), last->front()});
}

}  // namespace

Result<std::vector<Study>> figure_210(const Design& design) {
  std::vector<Study> studies;
  for (const char* array : {"cD", "wD", "tkD"}) {
    for (const double shield_mm : {3.0, 4.0}) {
      Design one = design;
      one.array = array;
      one.shield.diameter_mm = shield_mm;
      auto study = Study::of(one);
      if (!study) return study.error();
      studies.push_back(std::move(*study));
    }
  }
  return studies;
}

Picture curves_picture(const std::vector<Study>& studies, const model::OffsetGrid& grid,
                       std::optional<Point> forces_n) {
  Picture picture;
  picture.columns = studies.size() > 1 ? 2 : 1;
  const bool figure = studies.size() > 1 &&
                      std::any_of(studies.begin(), studies.end(),
                                  [](const Study& one) { return is_of_the_thesis(one.design()); });
  picture.title = std::string("Force on a pin that alone is moved") +
                  (figure ? " (thesis Fig. 2.10), " : ", ") +
                  std::string(model::name_of(studies.front().design().settings.model)) + " model";
  const bool as_thesis = !forces_n && studies.size() > 1;
  for (const Study& study : studies) {
    Panel panel = panel_of(study, grid);
    panel.y_range = as_thesis ? kThesisForcesN : forces_n.value_or(Point{});
    panel.y_tick = as_thesis ? kThesisForceTickN : 0.0;
    picture.panels.push_back(std::move(panel));
  }
  return picture;
}

Result<void> run_curves(const CurvesOptions& options, const Screen& screen) {
  const auto offsets = parse_range(options.offsets, 0.5, -20.0, 100.0, "--offsets");
  if (!offsets) return offsets.error();
  if (offsets->size() < 2)
    return Problem{kUsage, "--offsets: must be a range such as -2.5..12.5/0.5"};
  const model::OffsetGrid grid{offsets->front(), offsets->back(), (*offsets)[1] - (*offsets)[0]};
  const auto forces = forces_of(options.forces);
  if (!forces) return forces.error();
  const auto design = design_from(options.design);
  if (!design) return design.error();
  if (grid.first_mm <= -design->sphere_mm) {
    return Problem{kUsage, "--offsets: " + to_text(grid.first_mm) +
                               " mm is beyond the centre of a sphere of " +
                               to_text(design->sphere_mm) + " mm"};
  }
  const bool figure = options.design.names_no_array() && !options.design.shield;
  std::vector<Study> studies;
  if (figure) {
    auto six = figure_210(*design);
    if (!six) return six.error();
    studies = std::move(*six);
  } else {
    auto one = Study::of(*design);
    if (!one) return one.error();
    studies.push_back(std::move(*one));
  }
  const auto drawn = draw(curves_picture(studies, grid, *forces), options.pictures);
  if (!drawn) return drawn.error();
  if (screen.format == Format::kCsv) {
    screen.out << csv_of(studies, grid);
  } else if (screen.format == Format::kText) {
    screen.out << text_of(studies);
  } else if (figure) {
    Json panels = Json::array();
    for (const Study& study : studies) panels.push_back(study_json(study, grid));
    screen.out << Json{{"panels", panels}}.dump(2) << "\n";
  } else {
    screen.out << study_json(studies.front(), grid).dump(2) << "\n";
  }
  return {};
}

}  // namespace hedgehog::design

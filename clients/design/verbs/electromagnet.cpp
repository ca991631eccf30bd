// SPDX-License-Identifier: MIT
#include "clients/design/verbs/electromagnet.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "clients/common/text.h"
#include "clients/design/verbs/curves.h"
#include "clients/design/verbs/verbs.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShownPins = 12;

Json json_of(const CoilStudy& coil) {
  const auto calibration_json = [](double force_n, const model::Stroke& stroke) {
    return Json{{"force_n", force_n},
                {"extension_mm", stroke.extension_mm},
                {"at_casing", stroke.at_casing}};
  };
  Json root{{"pin", coil.pin},
            {"class_size", coil.class_size},
            {"rest_mm", coil.rest_mm},
            {"preload_n", coil.preload_n}};
  for (const CoilRow& row : coil.rows) {
    root["currents"].push_back(
        {{"current_a", row.current_a},
         {"fea", calibration_json(row.fea_force_n, row.fea)},
         {"measured", calibration_json(row.measured_force_n, row.measured)}});
  }
  root["spread"] = Json::array();
  for (const model::Activation& one : coil.spread) {
    root["spread"].push_back(
        {{"pin", one.id}, {"angle_deg", one.angle_deg}, {"fraction", one.fraction}});
  }
  root["pins_above_90_percent"] = coil.pins_above(0.9);
  root["pins_above_50_percent"] = coil.pins_above(0.5);
  root["pins_pulled_in"] = coil.pins_pulled_in();
  return root;
}

void print_text(const Study& study, const CoilStudy& coil, std::ostream& out) {
  out << "  aimed at pin " << coil.pin << " (class of " << coil.class_size << ") of "
      << to_text(study.design()) << "\n  " << standing_text(coil) << "\n\n"
      << coil_table(coil).text() << "\n";
  const double travel_mm = model::PinTravel{}.highest_mm;
  if (std::any_of(coil.rows.begin(), coil.rows.end(),
                  [](const CoilRow& row) { return row.fea.at_casing || row.measured.at_casing; }))
    out << "  the casing stops the pin " << to_text(travel_mm) << " mm outside the sphere\n\n";
  out << client::wrapped(
             "N: on the pin at its rest. Simulated: 0.4 N at 15 A on the thesis' pin on the sphere "
             "(Fig. 2.9); measured: 0.0126 N/A on it at its rest (Table 3.1). The thesis' two "
             "electromagnets differ by 2; its ball reached 0.5 mm at 15 A.",
             78, 2)
      << "\n  while it is aimed at pin " << coil.pin << ", the others get:\n\n";
  Table spread({{"pin", "pin"}, {"angle deg", "angle_deg"}, {"part of the force", "fraction"}});
  for (std::size_t i = 0; i < std::min(kShownPins, coil.spread.size()); ++i) {
    const model::Activation& one = coil.spread[i];
    spread.add(
        {std::to_string(one.id), fixed(one.angle_deg, 1), fixed(100.0 * one.fraction, 1) + " %"});
  }
  out << spread.text() << "\n  of " << coil.spread.size() << " pins " << coil.pins_above(0.9)
      << " get 90 % or more, " << coil.pins_above(0.5) << " get half or more, "
      << coil.pins_pulled_in() << " are pulled in\n";
}

Series marks(const std::string& name, std::vector<Point> points, int colour) {
  return {name, std::move(points), Series::Style::kMarks, colour};
}

}  // namespace

std::size_t CoilStudy::pins_above(double fraction) const noexcept {
  return static_cast<std::size_t>(std::count_if(
      spread.begin(), spread.end(),
      [&](const model::Activation& one) { return one.fraction >= fraction - 1e-9; }));
}

std::size_t CoilStudy::pins_pulled_in() const noexcept {
  return static_cast<std::size_t>(std::count_if(
      spread.begin(), spread.end(),
      [](const model::Activation& one) { return one.fraction < -1e-9; }));
}

Result<CoilStudy> study_coil(const Study& study, std::optional<int> pin,
                             const std::vector<double>& currents_a) {
  CoilStudy coil;
  coil.pin = pin.value_or(study.typical().pins().pins.front());
  const ClassStudy* one = study.class_of(coil.pin);
  if (one == nullptr) return Problem{kUsage, "--pin: there is no pin " + std::to_string(coil.pin)};
  if (one->standing() == Standing::kPushedOut) {
    return Problem{kBadData,
                   "pin " + std::to_string(coil.pin) + " has no rest: nothing draws it back"};
  }
  coil.class_size = one->size();
  coil.rest_mm = *one->rest_mm();
  coil.preload_n = one->character.preload_n();
  const auto push = [&](const model::Electromagnet& magnet, double current_a, double& force_n,
                        model::Stroke& moved) {
    const model::Push push_n = model::coil_push(magnet, current_a, study.design().sizes());
    force_n = push_n(coil.rest_mm);
    moved = *model::stroke(one->force, one->character, push_n);
  };
  for (const double current_a : currents_a) {
    CoilRow row;
    row.current_a = current_a;
    push(model::fea_electromagnet(), current_a, row.fea_force_n, row.fea);
    push(model::measured_electromagnet(), current_a, row.measured_force_n, row.measured);
    coil.rows.push_back(row);
  }
  coil.spread = model::activation_spread(study.arrangement(), coil.pin);
  return coil;
}

Table coil_table(const CoilStudy& coil) {
  Table table({{"A", "current_a"},
               {"simulated N", "fea_force_n"},
               {"moves mm", "fea_extension_mm"},
               {"measured N", "measured_force_n"},
               {"moves mm", "measured_extension_mm"}});
  for (const CoilRow& row : coil.rows) {
    table.add({to_text(row.current_a), fixed(row.fea_force_n, 3), fixed(row.fea.extension_mm, 3),
               fixed(row.measured_force_n, 3), fixed(row.measured.extension_mm, 3)});
  }
  return table;
}

std::string standing_text(const CoilStudy& coil) {
  if (coil.preload_n <= 0.0) return "it rests " + fixed(coil.rest_mm, 3) + " mm outside the sphere";
  return "it is pressed onto the shell with " + fixed(coil.preload_n, 3) +
         " N, below which no push moves it";
}

Result<Picture> coil_picture(const Study& study, int pin, double max_a) {
  std::vector<double> currents;
  for (int i = 0; i <= 60; ++i) currents.push_back(max_a / 60.0 * i);
  const auto coil = study_coil(study, pin, currents);
  if (!coil) return coil.error();
  std::vector<Point> fea_force;
  std::vector<Point> fea_mm;
  std::vector<Point> measured_force;
  std::vector<Point> measured_mm;
  for (const CoilRow& row : coil->rows) {
    fea_force.push_back({row.current_a, row.fea_force_n});
    measured_force.push_back({row.current_a, row.measured_force_n});
    fea_mm.push_back({row.current_a, row.fea.extension_mm});
    measured_mm.push_back({row.current_a, row.measured.extension_mm});
  }
  const std::string aimed =
      "pin " + std::to_string(pin) + ", class of " + std::to_string(coil->class_size);
  Panel force{"Force on it at rest",    "current (A)", "force outwards (N)", {}, {},
              {0, max_a * 31.0 / 30.0}, {0, 0}};
  force.series = {{"electromagnet as simulated", fea_force, Series::Style::kLine, 0},
                  {"electromagnet as measured", measured_force, Series::Style::kLine, 1}};
  Panel extension{"How far it moves out",   "current (A)", "extension (mm)", {}, {},
                  {0, max_a * 31.0 / 30.0}, {0, 0}};
  extension.series = {{"electromagnet as simulated", fea_mm, Series::Style::kLine, 0},
                      {"electromagnet as measured", measured_mm, Series::Style::kLine, 1}};
  if (has_thesis_magnets(study.design()) && study.arrangement().name.starts_with("tkD")) {
    force.series.push_back(marks("thesis Fig. 2.9: 0.4 N", {{15, 0.4}}, 0));
    force.series.push_back(marks("thesis Table 3.1: 0.0126 N/A", {{5, 0.063}, {15, 0.189}}, 1));
    extension.series.push_back(
        marks("thesis: 0.06 mm at 5 A, 0.5 mm at 15 A", {{5, 0.06}, {15, 0.5}}, 6));
  }
  Panel spread{"Force on the other pins",
               "angle from the aimed pin (degrees)",
               "part of its force (%)",
               {},
               {},
               {0, 180},
               {-105, 105}};
  std::vector<Point> pins;
  for (const model::Activation& one : coil->spread)
    pins.push_back({one.angle_deg, 100.0 * one.fraction});
  spread.series = {
      marks("a pin", std::move(pins), 2),
      {"just felt at 15 A (thesis: 2.1 A)", {{0, 14}, {180, 14}}, Series::Style::kDashed, 7}};
  Picture picture;
  picture.title = "The electromagnet aimed at " + aimed + " of " + study.arrangement().name;
  picture.panels = {std::move(force), std::move(extension), std::move(spread)};
  picture.columns = 2;
  return picture;
}

Result<void> run_electromagnet(const ElectromagnetOptions& options, const Screen& screen) {
  const auto currents = parse_range(options.currents, 2.5, 0.0, 100.0, "--current");
  if (!currents) return currents.error();
  const auto design = design_from(options.design);
  if (!design) return design.error();
  const auto study = Study::of(*design);
  if (!study) return study.error();
  const auto coil = study_coil(*study, options.pin, *currents);
  if (!coil) return coil.error();
  if (!options.pictures.svg.empty() || !options.pictures.png.empty()) {
    const auto picture =
        coil_picture(*study, coil->pin, std::max(model::kBurstCurrentA, currents->back()));
    if (!picture) return picture.error();
    const auto drawn = draw(*picture, options.pictures);
    if (!drawn) return drawn.error();
  }
  switch (screen.format) {
    case Format::kJson:
      screen.out << json_of(*coil).dump(2) << "\n";
      break;
    case Format::kCsv:
      screen.out << coil_table(*coil).csv();
      break;
    case Format::kText:
      print_text(*study, *coil, screen.out);
      break;
  }
  return {};
}

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "clients/common/text.h"
#include "clients/design/casing/casing.h"
#include "clients/design/input/design_file.h"
#include "clients/design/output/table.h"
#include "clients/design/output/tool.h"
#include "clients/design/search/search.h"
#include "clients/design/verbs/curves.h"
#include "clients/design/verbs/verbs.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShownRows = 15;
constexpr std::size_t kBarCells = 20;

Result<Demands> demands_of(const ChooseOptions& options) {
  struct Limit {
    const char* flag;
    double value;
    double most;
  };
  for (const Limit& limit :
       {Limit{"--wall", options.wall_mm, 20.0}, Limit{"--margin", options.margin_percent, 50.0},
        Limit{"--least-extension", options.min_extension_mm, 1.5}}) {
    if (!(limit.value >= 0.0 && limit.value <= limit.most)) {
      return Problem{kUsage,
                     std::string(limit.flag) + ": must be from 0 to " + to_text(limit.most)};
    }
  }
  return Demands{options.wall_mm, options.margin_percent / 100.0, options.min_extension_mm};
}

/// Without duplicates, in the order of first occurrence.
std::vector<std::string> distinct(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names)
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  return once;
}

Result<SearchSpace> space_of(const ChooseOptions& options) {
  SearchSpace space;
  space.arrays = distinct(options.arrays);
  if (space.arrays.empty())
    space.arrays = {"GP(1,1)", "cD", "wD", "tkD", "GP(2,2)", "GP(3,1)", "GP(4,0)"};
  const auto pins = parse_sizes(options.pins, 0.5, "--pins");
  if (!pins) return pins.error();
  const auto shields = parse_sizes(options.shields, 0.05, "--shields");
  if (!shields) return shields.error();
  const auto spheres = parse_range(options.spheres, 0.25, 10, 200, "--spheres");
  if (!spheres) return spheres.error();
  space.pins = *pins;
  space.shields = *shields;
  space.spheres_mm = *spheres;
  if (!options.coil_forces.empty()) {
    const auto forces = parse_range(options.coil_forces, 0.05, 0.001, 100, "--coil-force");
    if (!forces) return forces.error();
    space.coil_forces_n = *forces;
  }
  constexpr std::size_t kMaxCandidates = 5'000'000;
  if (space.size() > kMaxCandidates) {
    return Problem{
        kUsage,
        "these are " + std::to_string(space.size()) +
            " designs, more than five million; narrower ranges or larger steps (3..5/0.1) help"};
  }
  return space;
}

/// 12 480
std::string grouped(std::size_t number) { return base::grouped(static_cast<double>(number)); }

Table table_of(const std::vector<Found>& front, std::size_t most) {
  Table table({{"array", "array", true},
               {"pins", "pins"},
               {"pin", "magnet"},
               {"shield", "shield"},
               {"sphere", "sphere_mm"},
               {"across", "outer_diameter_mm"},
               {"coil N", "coil_force_n"},
               {"rest", "rest_mm"},
               {"moves", "extension_mm"},
               {"wall", "wall_mm"},
               {"kg", "mass_kg"}});
  for (std::size_t i = 0; i < std::min(most, front.size()); ++i) {
    const Found& one = front[i];
    table.add({one.design.array, std::to_string(one.pins), to_text(one.design.magnet),
               to_text(one.design.shield), to_text(one.design.sphere_mm),
               fixed(one.outer_diameter_mm, 1), fixed(one.design.coil_force_n, 3),
               fixed(one.rest_mm, 2), fixed(one.extension_mm, 3), fixed(one.wall_mm, 2),
               fixed(one.mass_g / 1000.0, 3)});
  }
  return table;
}

Json json_of(const SearchOutcome& outcome) {
  Json root{{"looked_at", outcome.looked_at},
            {"fit", outcome.fit},
            {"feasible", outcome.feasible},
            {"refused_when_opened", outcome.refused_when_opened},
            {"front", Json::array()}};
  for (const Found& one : outcome.front) {
    root["front"].push_back({{"array", one.design.array},
                             {"pins", one.pins},
                             {"shields", one.shields},
                             {"magnet", to_text(one.design.magnet)},
                             {"shield", to_text(one.design.shield)},
                             {"sphere_mm", one.design.sphere_mm},
                             {"outer_diameter_mm", one.outer_diameter_mm},
                             {"coil_force_n", one.design.coil_force_n},
                             {"rest_mm", one.rest_mm},
                             {"extension_mm", one.extension_mm},
                             {"wall_mm", one.wall_mm},
                             {"mass_g", one.mass_g}});
  }
  root["best"] = outcome.front.empty() ? Json(nullptr) : root["front"].front();
  return root;
}

std::string summary(const Found& best) {
  return best.design.array + ", " + std::to_string(best.pins) + " pins " +
         to_text(best.design.magnet) + ", shields " + to_text(best.design.shield) + ", sphere " +
         to_text(best.design.sphere_mm) + " mm, " + fixed(best.extension_mm, 2) + " mm, " +
         fixed(best.mass_g / 1000.0, 1) + " kg";
}

Picture picture_of(const std::vector<Found>& front) {
  Panel panel{"Pareto-optimal designs by pins, movement, mass and size",
              "outer diameter (mm)",
              "extension of the typical pin (mm)",
              {},
              {},
              {0, 0},
              {0, 0}};
  std::vector<std::string> arrays;
  for (const Found& one : front)
    if (std::find(arrays.begin(), arrays.end(), one.design.array) == arrays.end())
      arrays.push_back(one.design.array);
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    Series series{arrays[a], {}, Series::Style::kMarks, static_cast<int>(a)};
    for (const Found& one : front)
      if (one.design.array == arrays[a])
        series.points.push_back({one.outer_diameter_mm, one.extension_mm});
    panel.series.push_back(std::move(series));
  }
  panel.series.push_back(
      {"the thesis' ball: tkD-86, 0.6 mm", {{100.0, 0.6}}, Series::Style::kCrosses, 6});
  Picture picture;
  picture.title = "Pareto front";
  picture.panels = {std::move(panel)};
  return picture;
}

/// A progress bar that is redrawn in its line, on a terminal only.
class Bar {
 public:
  Bar(std::ostream& out, std::size_t total)
      : out_(out), total_(total), shown_(::isatty(STDERR_FILENO) == 1) {}
  void show(std::size_t done) {
    if (!shown_) return;
    const std::size_t cells = total_ == 0 ? kBarCells : kBarCells * done / total_;
    std::string bar;
    for (std::size_t i = 0; i < kBarCells; ++i) bar += i < cells ? "█" : "░";
    out_ << "\r  " << bar << "  " << grouped(done) << " of " << grouped(total_) << " designs"
         << std::flush;
  }
  void clear() {
    if (shown_) out_ << "\r\x1b[K" << std::flush;
  }

 private:
  std::ostream& out_;
  std::size_t total_;
  bool shown_;
};

void print_text(const SearchOutcome& outcome, double seconds, const ChooseOptions& options,
                std::ostream& out) {
  out << "  " << grouped(outcome.looked_at) << " designs, " << grouped(outcome.fit) << " fit, "
      << grouped(outcome.feasible) << " feasible, " << outcome.front.size() << " on the front   "
      << fixed(seconds, 1) << " s\n";
  if (outcome.refused_when_opened > 0) {
    out << "  " << outcome.refused_when_opened
        << " more were, but with the fan's opening a pin is not held or the typical one moves too "
           "little\n";
  }
  if (outcome.front.empty()) {
    out << "  no design meets the requirements; relax --least-extension, --margin or --wall\n";
    return;
  }
  out << "\n" << table_of(outcome.front, kShownRows).text();
  if (outcome.front.size() > kShownRows)
    out << "  and " << outcome.front.size() - kShownRows << " more: --csv or --json lists them\n";
  out << "\n"
      << client::wrapped(
             "rest and moves: of the typical pin, the one with the median rest; 0 is the shell "
             "(stability tells of every pin)",
             78, 2);
  out << "\n  " << (options.save.empty() ? std::string("best") : options.save) << ": "
      << summary(outcome.front.front()) << "\n";
  const Found& best = outcome.front.front();
  if (best.wall_mm >= kNozzleMm) return;
  // The clearances around both magnets reduce the wall between them, and so do some hundredths at
  // the cavities' mouths.
  constexpr double kMouthsMm = 0.1;
  const double wanted_mm = kNozzleMm + 2.0 * kUsualClearanceMm + kMouthsMm;
  out << client::wrapped("its casing has walls of " + fixed(best.wall_mm, 2) + " mm at the usual " +
                             to_text(kUsualClearanceMm) +
                             " mm around a magnet, and a common nozzle prints " +
                             to_text(kNozzleMm) + " mm: --wall " + fixed(wanted_mm, 1) +
                             " finds balls that can be printed so, export --clearance 0.05 "
                             "leaves this one thicker walls",
                         78, 2);
}

}  // namespace

Result<void> run_choose(const ChooseOptions& options, const Screen& screen) {
  const auto space = space_of(options);
  if (!space) return space.error();
  const auto demands = demands_of(options);
  if (!demands) return demands.error();
  const auto search = Search::in(*space, *demands);
  if (!search) return search.error();
  for (const auto& possible :
       {options.pictures.check(),
        options.save.empty() ? Result<void>() : check_writable(options.save)})
    if (!possible) return possible.error();
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  Bar bar(screen.err, space->size());
  const auto begin = std::chrono::steady_clock::now();
  const SearchOutcome outcome = search->run(options.threads > 0 ? options.threads : cores,
                                            [&](std::size_t done) { bar.show(done); });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  bar.clear();
  switch (screen.format) {
    case Format::kJson:
      screen.out << json_of(outcome).dump(2) << "\n";
      break;
    case Format::kCsv:
      screen.out << table_of(outcome.front, outcome.front.size()).csv();
      break;
    case Format::kText:
      print_text(outcome, took.count(), options, screen.out);
      break;
  }
  if (!options.save.empty()) {
    if (outcome.front.empty())
      return Problem{kBadData, "no design meets the requirements: nothing is saved"};
    const auto saved = write_file(options.save, design_text(outcome.front.front().design));
    if (!saved) return saved.error();
  }
  return draw(picture_of(outcome.front), options.pictures);
}

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "clients/design/casing/casing.h"
#include "clients/design/device_file.h"
#include "clients/design/input/design_file.h"
#include "clients/design/input/positions_file.h"
#include "clients/design/output/table.h"
#include "clients/design/output/tool.h"
#include "clients/design/search/workers.h"
#include "clients/design/verbs/array_json.h"
#include "clients/design/verbs/verbs.h"

namespace hedgehog::design {
namespace {

namespace fs = std::filesystem;

/// Into the file, or onto the screen when that is "-" or nothing was named. A design file is not
/// written over: `--json best.json` is easily typed for `best.json --json`.
Result<void> deliver(const std::string& file, const std::string& content, const Screen& screen) {
  if (file.empty() || file == "-") {
    screen.out << content;
    return {};
  }
  if (load_design(file)) {
    return Complaint{
        kUsage, file +
                    " is a design file and is not written over; the design comes first: export " +
                    file + " --json"};
  }
  const auto written = write_file(file, content);
  if (!written) return written.error();
  screen.err << "  " << file << "\n";
  return {};
}

Result<Casing> casing_of(const ExportOptions& options, const Design& design,
                         const model::Arrangement& array) {
  if (options.facets < 8 || options.facets > 64 || options.facets % 4 != 0) {
    return Complaint{kUsage, "--facets: must be 8 to 64, a multiple of 4"};
  }
  if (!(options.clearance_mm >= 0.0 && options.clearance_mm <= 2.0)) {
    return Complaint{kUsage, "--clearance: must be from 0 to 2 mm"};
  }
  Casing casing;
  casing.sphere_mm = design.sphere_mm;
  casing.pin = design.magnet;
  casing.shield = design.shield;
  casing.clearance_mm = options.clearance_mm;
  casing.facets = options.facets;
  for (const auto& site : array.pins) casing.pins.push_back(site.direction);
  for (const auto& site : array.shields) casing.shields.push_back(site.direction);
  const double widest_mm = widest_fan_mm(casing);
  casing.fan_mm = options.fan_mm.value_or(widest_mm);
  if (!(casing.fan_mm >= 0.0 && casing.fan_mm <= widest_mm)) {
    return Complaint{kBadData, "--fan: " + to_text(casing.fan_mm) +
                                   " mm would cut into cavities; from 0 to " + to_text(widest_mm) +
                                   " mm is free at the bottom of this array"};
  }
  casing.notches_deg = notch_places(casing);
  return casing;
}

Result<void> render_halves(const std::string& scad, const std::string& folder,
                           const Screen& screen) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return Complaint{kCannotCreate, folder + " cannot be made: " + error.message()};
  constexpr std::array kParts{"upper", "lower"};
  std::array<std::optional<Result<std::size_t>>, 2> rendered;
  const auto file_of = [&](std::size_t i) {
    return (fs::path(folder) / (std::string(kParts[i]) + ".stl")).string();
  };
  screen.err << "  openscad renders both halves; minutes when --facets is high\n";
  work_through(
      2, 2, [&](std::size_t i) { rendered[i] = render_stl(scad, kParts[i], file_of(i)); },
      [](std::size_t) {});
  for (std::size_t i = 0; i < 2; ++i) {
    if (!*rendered[i]) return rendered[i]->error();
    screen.err << "  " << file_of(i) << "  closed, " << **rendered[i] << " triangles\n";
  }
  return {};
}

Result<void> write_casing(const ExportOptions& options, const Design& design,
                          const model::Arrangement& array, const Screen& screen) {
  const auto casing = casing_of(options, design, array);
  if (!casing) return casing.error();
  const std::string text = openscad_text(
      *casing, {"Casing of a Hedgehog ball in two halves: " + to_text(design),
                "made by hedgehog-design " HEDGEHOG_VERSION, "SPDX-License-Identifier: MIT"});
  const auto temporary = TemporaryFile::make(".scad");
  if (!temporary) return temporary.error();
  const std::string scad = options.scad.empty() ? temporary->path() : options.scad;
  const auto written = write_file(scad, text);
  if (!written) return written.error();
  if (!options.scad.empty()) screen.err << "  " << scad << "\n";
  return options.stl.empty() ? Result<void>() : render_halves(scad, options.stl, screen);
}

}  // namespace

Result<void> run_export(const ExportOptions& options, const Screen& screen) {
  const bool casing = !options.scad.empty() || !options.stl.empty();
  if (!options.csv && !options.json && !casing && options.device.empty()) {
    return Complaint{kUsage, "say what: --csv, --json, --scad FILE, --stl FOLDER, --device FILE"};
  }
  const auto design = design_from(options.design);
  if (!design) return design.error();
  const auto array = buildable_arrangement(*design);
  if (!array) return array.error();
  if (options.csv) {
    const auto done = deliver(*options.csv, positions_csv(*array, design->sizes()), screen);
    if (!done) return done.error();
  }
  if (options.json) {
    const auto done = deliver(*options.json, array_json(*design, *array), screen);
    if (!done) return done.error();
  }
  if (!options.device.empty()) {
    const auto text = device_text(*design, fs::path(options.device).stem().string());
    if (!text) return text.error();
    const auto written = write_file(options.device, *text);
    if (!written) return written.error();
    screen.err << "  " << options.device << "  for hedgehogd's devices.d\n";
  }
  return casing ? write_casing(options, *design, *array, screen) : Result<void>();
}

}  // namespace hedgehog::design

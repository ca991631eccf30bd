// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "clients/common/text.h"
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

/// An error if `path` is a design file.
Result<void> write_new(const std::string& path, const std::string& content) {
  const auto protected_path = protect_design(path);
  return protected_path ? write_file(path, content) : protected_path.error();
}

/// Writes to the file, or to the screen if that is "-" or empty.
Result<void> deliver(const std::string& file, const std::string& content, const Screen& screen) {
  if (file.empty() || file == "-") {
    screen.out << content;
    return {};
  }
  const auto written = write_new(file, content);
  if (!written) return written.error();
  screen.err << "  " << file << "\n";
  return {};
}

Result<Casing> requested_casing(const ExportOptions& options, const Design& design,
                                const model::Arrangement& array) {
  if (options.facets < 8 || options.facets > 64 || options.facets % 4 != 0)
    return Problem{kUsage, "--facets: must be 8 to 64, a multiple of 4"};
  if (const auto requested_mm = options.clearance_mm;
      requested_mm && !(*requested_mm >= 0.0 && *requested_mm <= 2.0))
    return Problem{kUsage, "--clearance: must be from 0 to 2 mm"};
  Casing casing = casing_of(design, array);
  casing.facets = options.facets;
  casing.clearance_mm = options.clearance_mm.value_or(widest_clearance_mm(casing, array));
  const double widest_mm = widest_fan_mm(casing);
  casing.fan_mm = options.fan_mm.value_or(widest_mm);
  if (!(casing.fan_mm >= 0.0 && casing.fan_mm <= widest_mm)) {
    return Problem{kBadData, "--fan: " + to_text(casing.fan_mm) +
                                 " mm would cut into cavities; from 0 to " + to_text(widest_mm) +
                                 " mm is free at the bottom of this array"};
  }
  const Wall wall = thinnest_wall(casing, array);
  if (!(wall.mm > 0.0)) {
    return Problem{kBadData, "the cavities of " + wall.between + " run into each other by " +
                                 fixed(-wall.mm, 2) +
                                 " mm; a smaller --clearance or more --facets may help"};
  }
  casing.notches_deg = notch_places(casing);
  return casing;
}

Result<void> render_halves(const std::string& scad, const std::string& folder,
                           const Screen& screen) {
  constexpr std::array kParts{"upper", "lower"};
  std::array<std::optional<Result<std::size_t>>, 2> rendered;
  const auto file_of = [&](std::size_t i) {
    return (fs::path(folder) / (std::string(kParts[i]) + ".stl")).string();
  };
  screen.err << "  openscad renders both halves; minutes when --facets is high\n";
  parallel_for(
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
  const auto casing = requested_casing(options, design, array);
  if (!casing) return casing.error();
  const std::string text = openscad_text(
      *casing, {"Casing of a Hedgehog ball in two halves: " + to_text(design),
                "made by hedgehog-design " HEDGEHOG_VERSION, "SPDX-License-Identifier: MIT"});
  const auto temporary = TemporaryFile::make(".scad");
  if (!temporary) return temporary.error();
  // The copy for openscad: the other one may be printed to the screen.
  const std::string& scad = temporary->path();
  const auto copied = write_file(scad, text);
  if (!copied) return copied.error();
  if (!options.scad.empty()) {
    const auto delivered = deliver(options.scad, text, screen);
    if (!delivered) return delivered.error();
  }
  if (!options.stl.empty()) {
    std::error_code error;
    fs::create_directories(options.stl, error);
    if (error) return Problem{kCannotCreate, options.stl + " cannot be made: " + error.message()};
  }
  const Wall wall = thinnest_wall(*casing, array);
  screen.err << "  thinnest wall " << fixed(wall.mm, 2) << " mm, between " << wall.between
             << "; clearance " << to_text(casing->clearance_mm) << " mm around a magnet\n";
  if (wall.mm < kNozzleMm) {
    screen.err << client::wrapped(
        "a common nozzle prints lines of " + to_text(kNozzleMm) +
            " mm and leaves thinner walls out, so that cavities open into each other there: print "
            "it in resin, or design thinner magnets or a larger sphere (choose --wall)",
        78, 2);
  }
  return options.stl.empty() ? Result<void>() : render_halves(scad, options.stl, screen);
}

}  // namespace

Result<void> run_export(const ExportOptions& options, const Screen& screen) {
  const bool casing = !options.scad.empty() || !options.stl.empty();
  if (!options.csv && !options.json && !casing && options.device.empty())
    return Problem{kUsage,
                   "give at least one of --csv, --json, --scad FILE, --stl FOLDER, --device FILE"};
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
    if (options.device == "-")
      return Problem{kUsage, "--device: the file's name is the ball's; '-' is none"};
    const auto text = device_text(*design, fs::path(options.device).stem().string());
    if (!text) return text.error();
    const auto written = write_new(options.device, *text);
    if (!written) return written.error();
    screen.err << "  " << options.device << "  for hedgehogd's devices.d\n";
  }
  return casing ? write_casing(options, *design, *array, screen) : Result<void>();
}

}  // namespace hedgehog::design

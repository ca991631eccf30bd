// SPDX-License-Identifier: MIT
#include "clients/design/verbs/extension_table.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "clients/common/text.h"
#include "clients/design/output/table.h"
#include "clients/design/verbs/verbs.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

/// The thesis computed near forces by finite elements at a few angles and interpolated linearly
/// (section 2.2); the true force is convex in the angle, so this overestimates it. The angles are
/// not published, so this is a possible reason, not a proven one.
std::string reason_for(const ClassStudy& one, const Design& design, double printed) {
  const std::string angle = fixed(one.pins().to_shields.front().angle_deg, 1);
  const std::string lines =
      "straight lines between finite-element values some degrees apart, as the thesis drew them,"
      " overstate the pull of shields at " +
      angle + "°";
  if (design.settings.model == model::ForceModel::kHybrid) {
    return "from 30° on these are dipoles, as in the thesis, but below that exact forces and not "
           "its"
           " finite-element values";
  }
  if (!one.crossings_mm) {
    const double held = -one.character.minimum_n;
    return "held with " + fixed(held, 3) + " N at most (" + fixed(one.character.minimum_mm, 2) +
           " mm), " + fixed(100.0 * (1.0 - held / design.coil_force_n), 0) + " % short of " +
           to_text(design.coil_force_n) + " N, so no extension follows; " + lines +
           ", perhaps by enough for " + fixed(printed, 1) + " mm";
  }
  return lines + " and with it the force that draws the pin back: perhaps by enough for " +
         fixed(printed, 1) + " mm";
}

std::string verdict(const ExtensionRow& row) {
  if (!row.thesis_mm) return "";
  return row.reproduced ? "agrees" : "not reproduced";
}

}  // namespace

std::vector<ExtensionRow> extension_rows(const Study& study) {
  const Design& design = study.design();
  // Other designs have no printed values.
  const bool printed_here = is_of_the_thesis(design);
  std::vector<ExtensionRow> rows;
  for (const ClassStudy& one : study.classes()) {
    ExtensionRow row{study.arrangement().name,
                     study.arrangement().pins.size(),
                     one.size(),
                     one.rest_mm(),
                     one.extension_mm(),
                     one.crossings_mm,
                     {},
                     false,
                     {}};
    if (printed_here) row.thesis_mm = thesis_extension_mm(row.array, row.size);
    row.reproduced = row.thesis_mm && row.crossings_mm &&
                     std::abs(*row.thesis_mm - *row.crossings_mm) <= kPrintedToleranceMm;
    if (row.thesis_mm && !row.reproduced) row.reason = reason_for(one, design, *row.thesis_mm);
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<std::vector<ExtensionRow>> table_21(const Design& design) {
  std::vector<ExtensionRow> rows;
  for (const char* array : {"cD", "wD", "tkD"}) {
    Design one = design;
    one.array = array;
    const auto study = Study::of(one);
    if (!study) return study.error();
    for (ExtensionRow& row : extension_rows(*study)) rows.push_back(std::move(row));
  }
  return rows;
}

Table extension_table(const std::vector<ExtensionRow>& rows) {
  Table table({{"array", "array", true},
               {"faces", "faces"},
               {"class", "class_size"},
               {"rest mm", "rest_mm"},
               {"moves mm", "extension_mm"},
               {"crossings", "crossings_mm"},
               {"thesis mm", "thesis_mm"},
               {"", "verdict", true}});
  for (const ExtensionRow& row : rows) {
    table.add({row.array, std::to_string(row.faces), std::to_string(row.size),
               fixed(or_none(row.rest_mm), 3), fixed(or_none(row.extension_mm), 3),
               fixed(or_none(row.crossings_mm), 3), row.thesis_mm ? fixed(*row.thesis_mm, 1) : "",
               verdict(row)});
  }
  return table;
}

Result<void> run_table(const TableOptions& options, const Screen& screen) {
  const auto design = design_from(options.design);
  if (!design) return design.error();
  std::vector<ExtensionRow> rows;
  if (options.design.names_no_array()) {
    auto all = table_21(*design);
    if (!all) return all.error();
    rows = std::move(*all);
  } else {
    const auto study = Study::of(*design);
    if (!study) return study.error();
    rows = extension_rows(*study);
  }
  if (screen.format == Format::kJson) {
    Json root{{"coil_force_n", design->coil_force_n}, {"rows", Json::array()}};
    for (const ExtensionRow& row : rows) {
      root["rows"].push_back({{"array", row.array},
                              {"faces", row.faces},
                              {"class_size", row.size},
                              {"rest_mm", or_none(row.rest_mm)},
                              {"extension_mm", or_none(row.extension_mm)},
                              {"crossings_mm", or_none(row.crossings_mm)},
                              {"thesis_mm", or_none(row.thesis_mm)},
                              {"reproduced", row.thesis_mm ? Json(row.reproduced) : Json(nullptr)},
                              {"reason", row.reason}});
    }
    screen.out << root.dump(2) << "\n";
  } else if (screen.format == Format::kCsv) {
    screen.out << extension_table(rows).csv();
  } else {
    screen.out
        << client::wrapped(
               "how far a push of " + to_text(design->coil_force_n) +
                   " N moves a pin: from its rest, which the shell stops at 0; and from "
                   "zero crossing to crossing of the force curve, as thesis Table 2.1 counts",
               78, 2)
        << "\n"
        << extension_table(rows).text();
    for (const ExtensionRow& row : rows) {
      if (!row.reason.empty()) {
        screen.out << "\n"
                   << client::wrapped(
                          row.array + ", class of " + std::to_string(row.size) + ": " + row.reason,
                          78, 2);
      }
    }
  }
  return {};
}

}  // namespace hedgehog::design

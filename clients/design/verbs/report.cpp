// SPDX-License-Identifier: MIT
#include <cmath>

#include "clients/common/html.h"
#include "clients/design/ball_numbers.h"
#include "clients/design/input/design_file.h"
#include "clients/design/output/table.h"
#include "clients/design/output/tool.h"
#include "clients/design/verbs/curves.h"
#include "clients/design/verbs/electromagnet.h"
#include "clients/design/verbs/extension_table.h"
#include "clients/design/verbs/verbs.h"

namespace hedgehog::design {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
body { font: 16px/1.5 system-ui, sans-serif; max-width: 78rem; margin: 2rem auto; padding: 0 1rem; color: #222; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.5rem; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .8rem; text-align: right; border-bottom: 1px solid #ddd; }
.l { text-align: left; } th { border-bottom: 2px solid #888; font-weight: 600; }
.wide { overflow-x: auto; } h1, p { overflow-wrap: anywhere; }
svg { width: 100%; height: auto; } .note { color: #555; max-width: 46rem; } .bad { color: #b00020; font-weight: 600; }
</style>
)";

std::string paragraph(const std::string& text, const char* kind = "note") {
  return std::string("<p class=\"") + kind + "\">" + client::escape_html(text) + "</p>\n";
}

std::string heading(const std::string& text) {
  return "<h2>" + client::escape_html(text) + "</h2>\n";
}

Table numbers_of(const Study& study) {
  const Design& design = study.design();
  Table table({{"", "what", true}, {"", "value", true}});
  table.add({"array", study.arrangement().name});
  table.add({"pins, shields", std::to_string(study.arrangement().pins.size()) + ", " +
                                  std::to_string(study.arrangement().shields.size())});
  table.add({"pin magnet, shield magnet",
             to_text(design.magnet) + " mm, " + to_text(design.shield) + " mm"});
  table.add({"sphere, outside", to_text(design.sphere_mm) + " mm radius, " +
                                    fixed(outer_diameter_mm(design), 1) + " mm across"});
  const BallMass mass = mass_of(study.arrangement(), design);
  table.add({"mass", fixed(mass.total_g() / 1000.0, 2) + " kg, of it the casing " +
                         fixed(mass.casing_g / 1000.0, 2) + " kg when printed solid in PLA"});
  table.add({"coil force", to_text(design.coil_force_n) + " N"});
  for (const model::MagnetGap& gap : model::smallest_gaps(study.arrangement(), design.sizes())) {
    table.add({"smallest gap " + std::string(model::name_of(gap.kind_a)) + " to " +
                   std::string(model::name_of(gap.kind_b)),
               fixed(gap.gap_mm, 2) + " mm"});
  }
  return table;
}

std::string stability_html(const Study& study) {
  const std::vector<int> unstable = study.unstable_pins();
  std::string html = heading("Stability");
  if (study.stable()) {
    html += paragraph("Every pin rests: all " + std::to_string(study.arrangement().pins.size()) +
                      " are stable.");
  }
  if (!unstable.empty()) {
    html += paragraph(std::to_string(unstable.size()) + " pins are unstable: " + ids_text(unstable),
                      "bad");
  }
  for (const bool with_zero : {true, false}) {
    const std::vector<int> pressed = study.pressed_pins(with_zero);
    if (pressed.empty()) continue;
    html += paragraph(std::to_string(pressed.size()) + " pins are pressed onto the shell" +
                          (with_zero ? ": " : " and have no rest, the shields are too strong: ") +
                          ids_text(pressed),
                      with_zero ? "note" : "bad");
  }
  Table table({{"pins", "class_size"},
               {"rest mm", "rest_mm"},
               {"pressed N", "preload_n"},
               {"stiffness N/mm", "stiffness_n_mm"},
               {"held up to N", "held_n"},
               {"moves mm", "extension_mm"},
               {"which", "pins", true}});
  for (const ClassStudy& one : study.classes()) {
    const auto& c = one.character;
    table.add({std::to_string(one.size()), fixed(or_none(one.rest_mm()), 3),
               fixed(c.preload_n(), 3), c.stable() ? fixed(c.stiffness_n_mm, 3) : "none",
               fixed(or_none(one.held_n()), 3), fixed(or_none(one.extension_mm()), 3),
               ids_text(one.pins().pins)});
  }
  return html + table.html();
}

Result<std::string> coil_html(const Study& study) {
  std::string html = heading("Electromagnet");
  const auto coil = study_coil(study, {}, {0.0, 2.1, 5.0, 7.5, 10.0, 12.5, 15.0});
  if (!coil) return html + paragraph("Not shown: " + coil.error().message + ".", "bad");
  const auto picture = coil_picture(study, coil->pin, model::kBurstCurrentA);
  if (!picture) return picture.error();
  const auto svg = draw_svg(*picture);
  if (!svg) return svg.error();
  html += paragraph(
      "Simulated: 0.4 N at 15 A on the sphere (thesis Fig. 2.9). Measured: 0.0126 N/A on a pin at "
      "its rest (Table 3.1). The two differ by 2.");
  return html + paragraph(standing_text(*coil)) + coil_table(*coil).html() + *svg +
         paragraph("Aimed at pin " + std::to_string(coil->pin) + ", " +
                   std::to_string(coil->pins_above(0.9)) + " pins get 90 % of the force or more, " +
                   std::to_string(coil->pins_above(0.5)) + " half or more, " +
                   std::to_string(coil->pins_pulled_in()) + " are pulled in.");
}

/// The thesis' three arrays, with the reasons for values that are not reproduced.
Result<std::string> thesis_html(const Design& design) {
  Design thesis;
  thesis.settings = design.settings;
  const auto rows = table_21(thesis);
  if (!rows) return rows.error();
  const auto six = figure_210(thesis);
  if (!six) return six.error();
  const auto svg = draw_svg(curves_picture(*six, model::kThesisGrid));
  if (!svg) return svg.error();
  std::string html = heading("For comparison: the arrays of the thesis (Table 2.1, Fig. 2.10)") +
                     extension_table(*rows).html();
  for (const ExtensionRow& row : *rows)
    if (!row.reason.empty())
      html += paragraph(row.array + ", class of " + std::to_string(row.size) + ": " + row.reason);
  return html + *svg;
}

Result<std::string> page_of(const Study& study) {
  const Design& design = study.design();
  const auto curves = draw_svg(curves_picture({study}, model::kThesisGrid));
  if (!curves) return curves.error();
  const auto coil = coil_html(study);
  if (!coil) return coil.error();
  const auto thesis = thesis_html(design);
  if (!thesis) return thesis.error();
  return kHead +
         ("<title>" + client::escape_html(study.arrangement().name) +
          "</title>\n</head>\n<body>\n<h1>") +
         client::escape_html(to_text(design)) + "</h1>\n" +
         paragraph("hedgehog-design " HEDGEHOG_VERSION ", " +
                   std::string(model::name_of(design.settings.model)) + " model, accuracy " +
                   to_text(100.0 * design.settings.accuracy) + " % of each pair's force") +
         numbers_of(study).html() + stability_html(study) + heading("Force curves") + *curves +
         *coil + *thesis + "</body>\n</html>\n";
}

}  // namespace

Result<void> run_report(const ReportOptions& options, const Screen& screen) {
  const auto design = design_from(options.design);
  if (!design) return design.error();
  const auto study = Study::of(*design);
  if (!study) return study.error();
  const auto page = page_of(*study);
  if (!page) return page.error();
  const auto protected_path = protect_design(options.output);
  if (!protected_path) return protected_path.error();
  const auto written = write_file(options.output, *page);
  if (!written) return written.error();
  screen.err << "  " << options.output << "\n";
  return {};
}

}  // namespace hedgehog::design

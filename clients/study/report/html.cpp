// SPDX-License-Identifier: MIT
#include "clients/study/report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "clients/common/html.h"
#include "clients/study/report/figures.h"
#include "clients/study/rules/distinguishable_levels.h"
#include "clients/study/rules/observer.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>Hedgehog study</title><style>
body { font: 15px/1.5 "DejaVu Sans", system-ui, sans-serif; color: #22282d; max-width: 960px; margin: 2em auto; padding: 0 1em }
h1, h2 { font-weight: 600; line-height: 1.2 } h2 { margin-top: 2em }
table { border-collapse: collapse; margin: 1em 0; font-size: 14px }
th, td { text-align: left; padding: .3em .9em .3em 0; border-bottom: 1px solid #e3e7ea; vertical-align: top }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums }
.flag { color: #c0392b; white-space: nowrap } .quiet { color: #6b767f } figure { margin: 1em 0 } svg { max-width: 100%; height: auto }
.wide { overflow-x: auto } h1, p, td { overflow-wrap: anywhere } .wide * { overflow-wrap: normal }
@media (max-width: 600px) { body { margin: 1em auto } th, td { padding-right: .6em } figure { margin: 1em 0 } p.flag { white-space: normal } .wide td.n, .wide th { white-space: nowrap } }
</style></head><body>
)";

/// The SVG without its XML declaration, for embedding in the page.
std::string figure(const fs::path& file) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto begin = text.find("<svg");
  return begin == std::string::npos ? std::string()
                                    : "<figure>" + text.substr(begin) + "</figure>\n";
}

std::string group_table(const std::vector<AnalysedGroup>& groups) {
  std::string page =
      "<table><tr><th>experiment<th class=n>thesis<th class=n>here, mean ± SD<th class=n>n"
      "<th class=n>force<th>flagged</tr>\n";
  for (const AnalysedGroup& group : groups) {
    const char* unit = group.experiment.unit();
    page +=
        "<tr><td>" + client::escape_html(group.experiment.name) +
        (is_as_in_thesis(group.experiment)
             ? fmt::format("<td class=n>{:.3g} {}", thesis_result(group.experiment.quantity), unit)
             : std::string("<td class=n>–")) +
        fmt::format("<td class=n>{:.3g} ± {:.2g} {}<td class=n>{}<td class=n>", group.result.mean,
                    group.result.sd, unit, group.result.count) +
        (group.force_n > 0 ? fmt::format("{:.4f} N", group.force_n) : std::string("–")) +
        fmt::format("<td>{} of {}</tr>\n", group.flagged, group.result.count);
  }
  return page + "</table>\n";
}

/// ": force-jnd drops 2, nominally 80.35 % positive; ..."
std::string rules_in_words(const std::vector<AnalysedGroup>& groups) {
  std::string words;
  for (const AnalysedGroup& group : groups) {
    const Experiment& e = group.experiment;
    words +=
        (words.empty() ? ": " : "; ") + client::escape_html(e.name) +
        fmt::format(" drops {}, nominally {:.4g} % positive{}", e.rule.discard,
                    100.0 * convergence_point(e.rule),
                    e.task == Task::kYesNo ? " (of a yes/no task that label is nominal only)" : "");
  }
  return words;
}

std::string run_row(const AnalysedRun& analysed) {
  const RunAnalysis& a = analysed.analysis;
  const Experiment& e = analysed.run.header().experiment;
  std::string row = "<tr><td>" + client::escape_html(analysed.name.participant) + "<td>" +
                    client::escape_html(e.name) +
                    fmt::format("<td class=n>{}<td class=n>", analysed.name.run);
  if (a.threshold) {
    row += fmt::format("{:.4g} {}<td class=n>", *a.threshold, e.unit());
    row += a.interval ? fmt::format("{}{:.3g} to {}{:.3g}", a.interval->low_is_bound ? "≤ " : "",
                                    a.interval->low, a.interval->high_is_bound ? "≥ " : "",
                                    a.interval->high)
                      : "–";
    row += fmt::format("<td class=n>{:.4g}{}", a.fit->threshold,
                       a.fit->slope_at_bound || a.fit->threshold_at_bound ? " *" : "");
  } else {
    row += "–<td class=n>–<td class=n>–";
  }
  const auto& shown = analysed.run.state().shown();
  const auto& right = analysed.run.state().right();
  row += fmt::format("<td class=n>{}<td class=n>{}<td class=n>", a.scored,
                     analysed.run.state().voids());
  if (shown[0] + shown[1] > 0)
    row += fmt::format("{}/{}, {}/{}", right[0], shown[0], right[1], shown[1]);
  else
    row += fmt::format("{} of {}", analysed.run.state().false_alarms(),
                       analysed.run.state().catches());
  row += "<td class=flag>";
  for (std::size_t i = 0; i < a.flags.size(); ++i)
    row += (i == 0 ? "" : ", ") + std::string(name(a.flags[i]));
  if (analysed.excluded) row += std::string(a.flags.empty() ? "" : ", ") + "excluded";
  return row +
         (analysed.run.header().simulated_person ? " <span class=quiet>simulated</span>"
          : analysed.is_rehearsal()              ? " <span class=quiet>simulated ball</span>"
                                                 : "") +
         "</tr>\n";
}

std::string level_table(const std::vector<AnalysedGroup>& groups) {
  double threshold = thesis_result(Quantity::kCurrentA);
  double force = thesis_result(Quantity::kCurrentPercent);
  double speed = thesis_result(Quantity::kSpeedPercent);
  for (const AnalysedGroup& group : groups) {
    switch (group.experiment.quantity) {
      case Quantity::kCurrentA:
        threshold = group.result.mean;
        break;
      case Quantity::kCurrentPercent:
        force = group.result.mean;
        break;
      case Quantity::kSpeedPercent:
        speed = group.result.mean;
        break;
    }
  }
  std::string page =
      "<h2>Levels that can be distinguished</h2>\n<p>How many there are depends on the range and "
      "on "
      "the formula; the thesis names neither for its \"about 10\" of force and \"about 20\" of "
      "speed. A Weber fraction was measured at one reference, upwards only, and usually rises "
      "near the threshold.</p>\n<div class=wide><table><tr><th>range<th>formula<th class=n>steps, "
      "thesis' "
      "values<th class=n>steps, here<th class=n>levels, here<th></tr>\n";
  const auto thesis = level_formulas(2.1, 0.13, 0.49);
  const auto here = level_formulas(threshold, force / 100.0, speed / 100.0);
  for (std::size_t i = 0; i < here.size(); ++i) {
    page += "<tr><td>" + client::escape_html(here[i].range) + "<td>" +
            client::escape_html(here[i].formula) +
            fmt::format("<td class=n>{:.1f}<td class=n>{:.1f}<td class=n>{}<td class=quiet>",
                        thesis[i].count.steps, here[i].count.steps, here[i].count.levels) +
            client::escape_html(here[i].remark) + "</tr>\n";
  }
  return page + "</table></div>\n";
}

/// Excluded runs, with the reasons.
std::string exclusion_table(const std::vector<AnalysedRun>& runs) {
  std::string rows;
  for (const AnalysedRun& run : runs) {
    if (!run.excluded) continue;
    rows += "<tr><td>" + client::escape_html(run.name.participant) + "<td>" +
            client::escape_html(run.name.experiment) +
            fmt::format("<td class=n>{}<td>", run.name.run) +
            client::escape_html(run.excluded->reason) + "<td class=quiet>" +
            client::escape_html(run.excluded->time) + "</tr>\n";
  }
  if (rows.empty()) return {};
  return "<h2>Excluded runs</h2>\n<p>Not included in the means.</p>\n<div "
         "class=wide><table><tr><th>who"
         "<th>experiment<th class=n>run<th>reason<th>excluded at</tr>\n" +
         rows + "</table></div>\n";
}

/// Notes that the experimenter took during the runs.
std::string note_table(const std::vector<AnalysedRun>& runs) {
  std::string rows;
  for (const AnalysedRun& run : runs) {
    for (const Line& line : run.run.remarks()) {
      const Remark& remark = std::get<Remark>(line.event);
      if (remark.kind != "note") continue;
      rows += "<tr><td>" + client::escape_html(run.name.participant) + "<td>" +
              client::escape_html(run.name.experiment) +
              fmt::format("<td class=n>{}<td>", run.name.run) + client::escape_html(remark.text) +
              "<td class=quiet>" + client::escape_html(line.time) + "</tr>\n";
    }
  }
  if (rows.empty()) return {};
  return "<h2>Notes</h2>\n<div class=wide><table><tr><th>who<th>experiment<th class=n>run<th>note"
         "<th>when</tr>\n" +
         rows + "</table></div>\n";
}

std::string flag_table() {
  std::string page = "<h2>What the flags mean</h2>\n<div class=wide><table>\n";
  for (const Flag flag : {Flag::kNotFinished, Flag::kCeiling, Flag::kEarlyFloor, Flag::kFalseAlarms,
                          Flag::kGuessing, Flag::kZeroLevel, Flag::kDisagreement})
    page += "<tr><td class=flag>" + std::string(name(flag)) + "<td>" + meaning(flag) + "</tr>\n";
  return page + "</table></div>\n";
}

}  // namespace

std::string report_page(const StudyFolder& study, const std::vector<AnalysedRun>& runs,
                        const std::vector<AnalysedGroup>& groups, const fs::path& figures) {
  std::string page = kHead;
  page += "<h1>" + client::escape_html(study.path().filename().string()) + "</h1>\n";
  page += fmt::format(
      "<p class=quiet>{} participants planned, {} runs, seed {}, hedgehog-study {}"
      "</p>\n",
      study.plan().participants.size(), runs.size(), study.plan().seed, HEDGEHOG_VERSION);
  if (std::any_of(runs.begin(), runs.end(),
                  [](const AnalysedRun& r) { return r.is_rehearsal(); })) {
    page +=
        "<p class=flag>A rehearsal: simulated people, or people on a simulated ball, are among "
        "these.</p>\n";
  }
  page += "<div class=wide>" + group_table(groups) + "</div>\n" + figure(figures / "groups.svg");
  page +=
      "<p>The threshold of a person is the mean of all reversals but the first ones (thesis, "
      "section 3.2)" +
      rules_in_words(groups) +
      ". Groups are means with their standard deviation (n − 1) over each person's last finished "
      "run that is not excluded. The fit is a Weibull through all scored trials with 2 % lapses "
      "assumed; * where the answers leave its slope or its threshold at the edge of the search. "
      "The 95 % interval is its profile likelihood's; it is the curve's, and where the mean of the "
      "reversals lies outside of it the run is flagged. "
      "Part of the spread is the method's own: one run of a 13 % observer reads 7 to 24 % in "
      "95 of 100.</p>\n";
  page +=
      "<h2>Runs</h2>\n<div class=wide><table><tr><th>who<th>experiment<th class=n>run<th "
      "class=n>threshold"
      "<th class=n>95 % of the fit<th class=n>fit<th class=n>trials<th class=n>voids"
      "<th class=n>right with the test 1st, 2nd;<br>yes in catch trials<th>flags</tr>\n";
  for (const AnalysedRun& run : runs) page += run_row(run);
  page += "</table></div>\n" + exclusion_table(runs) + note_table(runs) + flag_table() +
          level_table(groups) + "<h2>Staircases</h2>\n";
  for (const AnalysedRun& run : runs) page += figure(figures / (figure_name(run) + ".svg"));
  return page + "</body></html>\n";
}

}  // namespace hedgehog::study

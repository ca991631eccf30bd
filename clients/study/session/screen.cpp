// SPDX-License-Identifier: MIT
#include "clients/study/session/screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hedgehog::study {

namespace {

constexpr int kChartRows = 9;
constexpr std::size_t kChartColumns = 66;
constexpr int kPhases = static_cast<int>(Phase::kOver) + 1;

std::string column(double value) { return fmt::format("{:>6.4g}", value); }

/// The last levels, one column per scored trial: filled if the response was positive.
std::vector<std::string> chart(const RunState& state) {
  const auto& all = state.judgements();
  const std::size_t first = all.size() > kChartColumns ? all.size() - kChartColumns : 0;
  double top = 0.0;
  for (std::size_t i = first; i < all.size(); ++i) top = std::max(top, all[i].level);
  top = top > 0.0 ? top : 1.0;
  std::vector<std::string> lines;
  for (int row = kChartRows - 1; row >= 0; --row) {
    const bool labelled = row % 4 == 0;
    std::string line = (labelled ? column(top * row / (kChartRows - 1)) : std::string(6, ' ')) +
                       (labelled ? " ┤" : " │");
    for (std::size_t i = first; i < all.size(); ++i) {
      const int place = static_cast<int>(std::lround(all[i].level / top * (kChartRows - 1)));
      line += place != row ? " " : all[i].positive ? "●" : "○";
    }
    lines.push_back(line);
  }
  lines.push_back("       └" + [] {
    std::string rule;
    for (std::size_t i = 0; i < kChartColumns; ++i) rule += "─";
    return rule;
  }());
  return lines;
}

std::string doing(const View& view) {
  switch (view.phase) {
    case Phase::kReady:
      return "ready";
    case Phase::kInterval:
      return "playing " + std::to_string(view.interval);
    case Phase::kQuestion:
      return "waiting for the answer";
    case Phase::kPaused:
      return "PAUSED";
    case Phase::kRest:
      return "REST";
    case Phase::kOver:
      break;
  }
  return "over";
}

}  // namespace

std::vector<std::string> experimenter_lines(const View& view) {
  const RecordedRun& run = *view.run;
  const Experiment& experiment = run.header().experiment;
  const Staircase& staircase = run.state().staircase();
  const auto next = run.state().next();
  const std::string trial =
      next ? std::string(name(next->kind)) + " trial " + std::to_string(next->number)
           : std::string(name(staircase.status()));
  std::vector<std::string> lines{
      "",
      fmt::format("  {} · {} · {} · {}", run.header().participant, experiment.name, trial,
                  doing(view)),
      fmt::format("  level {} {}   reversals {} of {}   voids {}   catch {}, yes in {}",
                  exact_decimal(staircase.level(), experiment.decimals()), experiment.unit(),
                  staircase.state().reversals.size(), experiment.rule.total_reversals(),
                  run.state().voids(), run.state().catches(), run.state().false_alarms()),
      ""};
  const auto picture = chart(run.state());
  lines.insert(lines.end(), picture.begin(), picture.end());
  lines.push_back("");
  lines.push_back("  " + run.header().ball.name +
                  (run.header().ball.simulated ? " (simulated)" : "") +
                  (view.temperature_c ? "   " + column(*view.temperature_c) + " °C" : ""));
  lines.push_back("  " + view.message);
  lines.push_back("");
  lines.push_back("  participant: <- " + std::string(experiment.task == Task::kYesNo
                                                         ? "no   yes ->"
                                                         : "first   second ->"));
  lines.emplace_back("  p pause   c continue   v void this trial   n note   q stop (resume later)");
  return lines;
}

Cue cue_of(const View& view) {
  const Experiment& experiment = view.run->header().experiment;
  return {view.phase, view.interval, experiment.task == Task::kTwoIntervals, experiment.question};
}

std::vector<std::string> participant_lines(const Cue& cue) {
  std::string text;
  std::string keys;
  switch (cue.phase) {
    case Phase::kReady:
      text = "Your hand on top of the ball, please.";
      break;
    case Phase::kInterval:
      text = !cue.two_intervals  ? "Feel."
             : cue.interval == 1 ? "Feel: the first."
                                 : "Feel: the second.";
      break;
    case Phase::kQuestion:
      text = cue.question;
      keys =
          cue.two_intervals ? "<-  the first          the second  ->" : "<-  no          yes  ->";
      break;
    case Phase::kPaused:
      text = "A short pause.";
      break;
    case Phase::kRest:
      text = "Rest for a while.";
      break;
    case Phase::kOver:
      text = "That was all. Thank you.";
      break;
  }
  return {"", "", "", "", "", "", "", "          " + text, "", "", "          " + keys};
}

std::vector<std::string> blind_lines(const View& view) {
  std::vector<std::string> lines = participant_lines(cue_of(view));
  if (view.waits) {
    const bool begins = view.phase == Phase::kReady;
    lines.insert(lines.end(), {"", "", begins ? "  c begins, q stops" : "  c goes on, q stops"});
  }
  return lines;
}

std::string encode(const Cue& cue) {
  return std::to_string(static_cast<int>(cue.phase)) + " " + std::to_string(cue.interval) + " " +
         (cue.two_intervals ? "1 " : "0 ") + cue.question;
}

Cue decode_cue(const std::string& line) {
  Cue cue;
  int phase = 0;
  int two = 0;
  int taken = 0;
  if (std::sscanf(line.c_str(), "%d %d %d %n", &phase, &cue.interval, &two, &taken) == 3 &&
      phase >= 0 && phase < kPhases) {
    cue.phase = static_cast<Phase>(phase);
    cue.two_intervals = two == 1;
    cue.question = line.substr(static_cast<std::size_t>(taken));
  }
  return cue;
}

}  // namespace hedgehog::study

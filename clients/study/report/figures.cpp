// SPDX-License-Identifier: MIT
#include "clients/study/report/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "clients/common/program.h"
#include "clients/study/rules/statistics.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;

constexpr const char* kScript = "figures.gnuplot";
constexpr const char* kLog = "gnuplot.log";
constexpr const char* kBlue = "#1f5fa8";
constexpr const char* kRed = "#c0392b";
constexpr const char* kGrey = "#9aa4ad";

std::string decimal(double value) { return fmt::format("{:.9g}", value); }

std::string axis_of(const Experiment& experiment) {
  switch (experiment.quantity) {
    case Quantity::kCurrentPercent:
      return "Difference of force [%]";
    case Quantity::kSpeedPercent:
      return "Difference of speed [%]";
    case Quantity::kCurrentA:
      break;
  }
  return "Current [A]";
}

std::string title_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kCurrentPercent:
      return "Force JND [%]";
    case Quantity::kSpeedPercent:
      return "Speed JND [%]";
    case Quantity::kCurrentA:
      break;
  }
  return "Force threshold [N]";
}

/// The value in the group figure: N for thresholds, as in the thesis.
double shown(const AnalysedRun& run) {
  return run.analysis.weber_fraction ? *run.analysis.threshold : *run.analysis.force_n;
}

/// Plots to an SVG and a PNG file.
std::string twice(const std::string& path, int width, int height, const std::string& plot) {
  const std::string size = std::to_string(width) + "," + std::to_string(height);
  return "set terminal svg size " + size + " font 'DejaVu Sans,13' background '#ffffff'\n" +
         "set output '" + path + ".svg'\n" + plot + "unset output\n" +
         "set terminal pngcairo size " + size + " font 'DejaVu Sans,11' background '#ffffff'\n" +
         "set output '" + path + ".png'\n" + plot + "unset output\n";
}

}  // namespace

std::string figure_name(const AnalysedRun& run) {
  return run.name.participant + "." + run.name.experiment + "." + std::to_string(run.name.run);
}

/// gnuplot refuses an axis without extent, and with it all figures that follow.
double axis_top(double highest) { return highest > 0.0 ? highest : 1.0; }

std::string staircase_plot(const AnalysedRun& analysed) {
  const Experiment& experiment = analysed.run.header().experiment;
  std::string levels;
  std::string reversals;
  double top = 0.0;
  int trials = 0;
  for (const TrialRecord& trial : analysed.run.trials()) {
    if (!trial.step) continue;
    const double level = to_value(trial.trial.level, experiment.decimals());
    const std::string point = std::to_string(trial.trial.number) + " " + decimal(level);
    levels += point + (trial.positive ? " 1\n" : " 0\n");
    if (trial.step->reversal > 0)
      reversals += point + " " + std::to_string(trial.step->reversal) + "\n";
    top = std::max(top, level);
    trials = std::max(trials, trial.trial.number);
  }
  top = axis_top(top);
  const std::string discard = std::to_string(experiment.rule.discard);
  const bool yes_no = experiment.task == Task::kYesNo;
  std::string plot =
      "reset\n$levels << END\n" + levels + "END\n$reversals << END\n" + reversals + "END\n" +
      "set title '" + analysed.name.participant + ", " + experiment.name +
      (analysed.excluded ? ", excluded" : "") + "' noenhanced\n" +
      "set xlabel 'Trial'\nset ylabel '" + axis_of(experiment) + "'\n" +
      "set xrange [0:" + std::to_string(trials + 1) + "]\nset yrange [0:" + decimal(top * 1.12) +
      "]\nset grid ytics lc '#e3e7ea' lt 1\nset border 3\nset tics nomirror\nset key top right\n";
  if (analysed.analysis.interval) {
    plot += "set object 1 rectangle from graph 0, first " +
            decimal(std::min(analysed.analysis.interval->low, top * 1.12)) + " to graph 1, first " +
            decimal(std::min(analysed.analysis.interval->high, top * 1.12)) +
            " fc '#dfe9f5' fs noborder behind\n";
  }
  plot += std::string("plot $levels using 1:2 with lines lc '") + kGrey + "' notitle, \\\n" +
          "  $levels using 1:($3 == 1 ? $2 : 1/0) with points pt 7 ps 0.8 lc '" + kBlue +
          "' title '" + (yes_no ? "yes" : "right") + "', \\\n" +
          "  $levels using 1:($3 == 0 ? $2 : 1/0) with points pt 6 ps 0.9 lw 1.5 lc '" + kRed +
          "' title '" + (yes_no ? "no" : "wrong") + "'";
  if (!reversals.empty()) {
    plot += ", \\\n  $reversals using 1:($3 > " + discard +
            " ? $2 : 1/0) with points pt 4 ps 1.7 lc '#333333' title "
            "'reversal', \\\n  $reversals using 1:($3 <= " +
            discard +
            " ? $2 : 1/0) with points pt 4 ps 1.7 lc '#b8c0c7' title "
            "'reversal, not in the mean'";
  }
  if (analysed.analysis.interval) {
    plot +=
        ", \\\n  NaN with boxes fs solid 1.0 noborder lc '#dfe9f5' title '95 % of the fitted "
        "curve'";
  }
  if (analysed.analysis.threshold) {
    const auto& flags = analysed.analysis.flags;
    const bool disputed = std::find(flags.begin(), flags.end(), Flag::kDisagreement) != flags.end();
    plot += fmt::format(
        ", \\\n  {:.9g} with lines dt 2 lw 1.5 lc '#333333' title 'mean of reversals, {:.4g} {}{}'",
        *analysed.analysis.threshold, *analysed.analysis.threshold, experiment.unit(),
        disputed ? " (fit and mean disagree)" : "");
  }
  return plot + "\n";
}

std::string group_plot(const std::vector<AnalysedGroup>& groups) {
  std::string plot = "reset\nset multiplot layout 1," + std::to_string(groups.size()) + "\n";
  for (const AnalysedGroup& group : groups) {
    const bool in_newton = group.experiment.quantity == Quantity::kCurrentA;
    const bool compared = is_as_in_thesis(group.experiment);
    // The thesis' value with the thesis' ball, each participant's value with the ball of the run.
    const double thesis =
        thesis_result(group.experiment.quantity) * (in_newton ? BallFacts{}.force_n_per_a : 1.0);
    std::string people;
    std::vector<double> values;
    double top = compared ? thesis : 0.0;
    for (std::size_t i = 0; i < group.runs.size(); ++i) {
      // Horizontal offsets, so that points do not overlap.
      const double offset = 0.09 * (static_cast<double>(i % 5) - 2.0);
      people += decimal(offset) + " " + decimal(shown(*group.runs[i])) + " " +
                (group.runs[i]->analysis.flags.empty() ? "0" : "1") + "\n";
      top = std::max(top, shown(*group.runs[i]));
      values.push_back(shown(*group.runs[i]));
    }
    const double middle = mean(values);
    const double spread = group.runs.size() > 1 ? standard_deviation(values) : 0.0;
    top = std::max(top, middle + spread);
    plot +=
        "$people << END\n" + people + "END\n$mean << END\n0.45 " + decimal(middle) + " " +
        decimal(spread) + "\nEND\nset title \"" + title_of(group.experiment.quantity) + "\\n" +
        group.experiment.name +
        "\" noenhanced\nset xrange [-0.5:0.75]\nset yrange [0:" + decimal(axis_top(top) * 1.15) +
        "]\nunset xtics\nset ytics nomirror\nset border 2\nset grid ytics lc '#e3e7ea' lt 1\n"
        "set key below maxrows 2 samplen 1.5\nplot " +
        (compared
             ? decimal(thesis) + " with lines dt 3 lw 1.5 lc '" + kGrey + "' title 'thesis', \\\n"
             : std::string()) +
        "  $people using 1:($3 == 0 ? $2 : 1/0) with points pt 7 ps 0.9 lc '" + kBlue +
        "' title 'person', \\\n" +
        "  $people using 1:($3 == 1 ? $2 : 1/0) with points pt 6 ps 1.0 lw 1.5 lc '" + kRed +
        "' title 'flagged', \\\n" +
        "  $mean using 1:2:3 with yerrorbars pt 5 ps 1.0 lw 1.8 lc '#333333' title 'mean, SD'\n";
  }
  return plot + "unset multiplot\n";
}

Result<void> draw(const fs::path& folder, const std::vector<AnalysedRun>& runs,
                  const std::vector<AnalysedGroup>& groups) {
  constexpr int kPanel = 300;
  std::string script;
  for (const AnalysedRun& run : runs)
    if (run.run.state().staircase().state().scored > 0)
      script += twice(figure_name(run), 720, 400, staircase_plot(run));
  if (!groups.empty())
    script += twice("groups", kPanel * static_cast<int>(groups.size()), 420, group_plot(groups));
  std::ofstream(folder / kScript) << script;
  // Run in the folder: a path may contain characters that are special in gnuplot.
  const auto end = client::run_program({"gnuplot", kScript}, kLog, folder.string());
  if (end.start_error != 0) return Problem{EX_UNAVAILABLE, "no figures: gnuplot is not installed"};
  if (!end.succeeded)
    return Problem{EX_UNAVAILABLE, "no figures: gnuplot failed, see " + (folder / kLog).string()};
  return {};
}

}  // namespace hedgehog::study

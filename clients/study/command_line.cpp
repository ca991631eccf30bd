// SPDX-License-Identifier: MIT
#include "clients/study/command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>

#include "cli/program.h"
#include "clients/common/arguments.h"
#include "clients/study/study_plan.h"
#include "clients/study/verbs/checklist_answers.h"
#include "clients/study/verbs/exclude_verb.h"
#include "clients/study/verbs/report_verbs.h"
#include "clients/study/verbs/run_verb.h"
#include "clients/study/verbs/simulate_verb.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

namespace {

/// Used in file names.
cli::Validator plain_name() {
  return {[](const std::string& id) {
            const bool plain =
                !id.empty() &&
                std::all_of(
                    id.begin(), id.end(),
                    [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
            return plain ? std::string() : std::string("letters, digits, '_' and '-' only");
          },
          "ID"};
}

/// A range of CLI11 accepts "nan", for which no comparison is true.
cli::Validator finite(double lowest, double highest) {
  return {[lowest, highest](const std::string& text) {
            const auto value = cli::number_of(text);
            const bool within = value && *value >= lowest && *value <= highest;
            return within ? std::string()
                          : fmt::format("must be a number from {:g} to {:g}, not {}", lowest,
                                        highest, text);
          },
          fmt::format("FLOAT in [{:g} - {:g}]", lowest, highest)};
}

/// Same validation as at the check list's prompt.
template <class T>
cli::Validator accepted(Result<T> (*parse)(std::string_view), const char* kind) {
  return {[parse](const std::string& text) {
            const auto value = parse(text);
            return value ? std::string() : value.error().message;
          },
          kind};
}

/// A readable text on one line.
cli::Validator reason() {
  return {[](const std::string& text) {
            constexpr std::size_t kLongest = 500;
            const bool readable =
                text.size() <= kLongest && text.find_first_not_of(" \t") != std::string::npos &&
                std::none_of(
                    text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; });
            return readable ? std::string()
                            : fmt::format("one line of 1 to {} characters", kLongest);
          },
          "TEXT"};
}

cli::Validator not_empty() {
  return {[](const std::string& text) {
            return text.empty() ? std::string("must not be empty") : std::string();
          },
          "NAME"};
}

class CommandLine {
 public:
  CommandLine() {
    app_.require_commands(1, 1);
    app_.add_option("-C", folder_, "as if started in this folder").existing_folder();
    app_.set_version(std::string("hedgehog-study " HEDGEHOG_VERSION));
    add_plan();
    add_run();
    add_resume();
    add_rehearse();
    add_status();
    add_analyse();
    add_export();
    add_exclude();
    add_levels();
    add_simulate();
    add_trace();
  }

  int run(int argc, const char* const* argv) {
    if (const auto code = client::parse_arguments(app_, argc, argv)) return *code;
    if (!folder_.empty()) std::filesystem::current_path(folder_);
    return chosen_();
  }

 private:
  void add_trace() {
    const cli::CommandSpec verb =
        app_.add_command("trace", "evaluates a sequence of responses with the staircase");
    verb.add_option("experiment", trace_.experiment, "a preset or a file").required();
    verb.add_option("--responses", trace_.responses,
                    "1 0: scored yes/correct, no/wrong; Y N: catch trial; T: void")
        .required();
    verb.add_flag("--json", trace_.json, "for programs");
    verb.on_given([this] { chosen_ = [this] { return run_trace(trace_); }; });
  }

  void add_simulate() {
    const cli::CommandSpec verb =
        app_.add_command("simulate", "runs simulated people, without a ball");
    verb.add_option("experiments", simulate_.experiments, "presets or files; default: all three");
    verb.add_option("--observers", simulate_.observers, "how many people")
        .range(1, 1'000'000)
        .show_default();
    verb.add_option("--seed", simulate_.seed).show_default();
    verb.add_option("--threads", simulate_.threads, "default: one a core").range(1, 256);
    verb.add_flag("--convergence", simulate_.convergence, "also the asymptotic level of long runs");
    verb.add_flag("--json", simulate_.json, "for programs");
    verb.on_given([this] { chosen_ = [this] { return run_simulate(simulate_); }; });
  }

  void add_address(const cli::CommandSpec& verb) {
    verb.add_option("--address", run_.address, "host:port or a socket's path (HEDGEHOG_ADDRESS)");
  }

  void add_plan() {
    const cli::CommandSpec verb = app_.add_command("plan", "makes the folder of a study");
    verb.add_option("folder", plan_.folder).required().check(not_empty());
    verb.add_option("--participants", plan_.participants).range(1, 99'999).show_default();
    verb.add_option("--seed", plan_.seed, "of everything drawn")
        .range(std::uint64_t{0}, kMaxSeed)
        .show_default();
    verb.add_option("--experiments", plan_.experiments, "with commas; default: the thesis' three")
        .delimiter(',');
    verb.on_given([this] { chosen_ = [this] { return run_plan(plan_); }; });
  }

  void add_run() {
    const cli::CommandSpec verb = app_.add_command("run", "one experiment with one participant");
    verb.add_option("experiment", run_.experiment, "a preset or a file").required();
    verb.add_option("--participant", run_.participant, "P01").required().check(plain_name());
    Checklist& list = run_.checklist;
    verb.add_option("--experimenter", list.experimenter, "a code; what is not given is asked for");
    verb.add_option("--consent", list.consent, "reference of the signed sheet");
    verb.add_option("--hand-size", list.hand_size_cm, "tip of the index finger to the wrist, cm")
        .check(accepted(parse_hand_size, "CM"));
    verb.add_option("--dominant-hand", list.dominant_hand).one_of({"left", "right"});
    verb.add_option("--age-band", list.age_band, "22-29, 70+")
        .check(accepted(parse_age_band, "YEARS"));
    verb.add_flag("--headphones", list.headphones, "they are on and running");
    verb.add_flag("--hand-on-top", list.hand_on_top, "it is");
    verb.add_flag("--again", run_.again, "another run of what was done or begun");
    verb.add_flag("--blind", run_.blind, "this screen is the participant's too: no levels");
    verb.add_flag("--simulated", run_.simulated, "a program answers");
    add_address(verb);
    verb.on_given([this] { chosen_ = [this] { return run_run(run_); }; });
  }

  void add_resume() {
    const cli::CommandSpec verb =
        app_.add_command("resume", "goes on with a run that was stopped or killed");
    verb.add_option("--participant", run_.participant, "default: the run touched last");
    verb.add_option("--experiment", run_.experiment);
    verb.add_flag("--blind", run_.blind, "as for run; default: as the run was started");
    add_address(verb);
    verb.on_given([this] { chosen_ = [this] { return run_resume(run_); }; });
  }

  void add_rehearse() {
    const cli::CommandSpec verb = app_.add_command(
        "rehearse", "the whole study with simulated participants, best with hedgehogd --speed 50");
    add_address(verb);
    verb.on_given([this] { chosen_ = [this] { return run_rehearse(run_); }; });
  }

  void add_status() {
    const cli::CommandSpec verb = app_.add_command("status", "who has done what");
    verb.add_flag("--json", json_, "for programs");
    verb.on_given([this] { chosen_ = [this] { return run_status(json_); }; });
    app_.add_command("participant", "the participant's own screen, in a second terminal")
        .on_given([this] { chosen_ = run_participant; });
  }

  void add_analyse() {
    const cli::CommandSpec verb = app_.add_command("analyse", "thresholds, figures and a report");
    verb.add_option("--out", analyse_.out, "folder; default: analysis in the study");
    verb.add_flag("--json", analyse_.json, "for programs");
    verb.on_given([this] { chosen_ = [this] { return run_analyse(analyse_); }; });
  }

  void add_export() {
    const cli::CommandSpec verb =
        app_.add_command("export", "the data, a row for each presentation");
    verb.add_option("--format", export_.format).one_of({"csv", "bids"}).show_default();
    verb.add_option("--out", export_.out, "default: data.csv or bids in the study");
    verb.add_option("--author", export_.authors,
                    "of the data, for BIDS, again for each; default: the experimenters' codes");
    verb.on_given([this] { chosen_ = [this] { return run_export(export_); }; });
  }

  cli::CommandSpec add_choice(const char* verb_name, const char* help) {
    const cli::CommandSpec verb = app_.add_command(verb_name, help);
    verb.add_option("participant", exclude_.participant, "P01").required();
    verb.add_option("experiment", exclude_.experiment).required();
    verb.add_option("--run", exclude_.run, "default: the last").range(1, 999'999);
    return verb;
  }

  void add_exclude() {
    const cli::CommandSpec verb =
        add_choice("exclude", "leaves a run out of the means, for a reason");
    verb.add_option("--reason", exclude_.reason, "shown in report and export")
        .required()
        .check(reason());
    verb.on_given([this] { chosen_ = [this] { return run_exclude(exclude_); }; });
    add_choice("include", "a run that was excluded counts again").on_given([this] {
      chosen_ = [this] { return run_include(exclude_); };
    });
  }

  void add_levels() {
    const cli::CommandSpec verb =
        app_.add_command("levels", "how many levels can be distinguished, by which formula");
    verb.add_option("--threshold-a", levels_.threshold_a, "least current that is felt")
        .check(finite(0.01, 14.99))
        .show_default();
    verb.add_option("--force-percent", levels_.force_percent, "JND of force")
        .check(finite(0.1, 1000.0))
        .show_default();
    verb.add_option("--speed-percent", levels_.speed_percent, "JND of speed")
        .check(finite(0.1, 1000.0))
        .show_default();
    verb.on_given([this] { chosen_ = [this] { return run_levels(levels_); }; });
  }

  cli::Program app_{
      "The perception experiments: how little force, and how small a difference of force "
      "or speed,\npeople feel.",
      "hedgehog-study"};
  std::function<int()> chosen_{};
  std::string folder_{};
  AnalyseOptions analyse_{};
  ExportOptions export_{};
  ExcludeOptions exclude_{};
  LevelsOptions levels_{};
  PlanOptions plan_{};
  RunOptions run_{};
  bool json_ = false;
  TraceOptions trace_{};
  SimulateOptions simulate_{};
};

}  // namespace

int run_command_line(int argc, const char* const* argv) { return CommandLine().run(argc, argv); }

}  // namespace hedgehog::study

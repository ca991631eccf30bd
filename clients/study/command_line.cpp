// SPDX-License-Identifier: MIT
#include "clients/study/command_line.h"

#include <sysexits.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <string>

#include "clients/study/verbs/simulate_verb.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

namespace {

class CommandLine {
 public:
  CommandLine() {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", std::string("hedgehog-study " HEDGEHOG_VERSION));
    add_trace();
    add_simulate();
  }

  int run(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::Success& done) {
      return app_.exit(done);
    } catch (const CLI::ParseError& error) {
      app_.exit(error, std::cerr, std::cerr);
      return EX_USAGE;
    }
    return chosen_();
  }

 private:
  void add_trace() {
    CLI::App* verb = app_.add_subcommand("trace", "puts a string of answers through a staircase");
    verb->add_option("experiment", trace_.experiment, "a preset or a file")->required();
    verb->add_option("--responses", trace_.responses,
                     "1 0: scored yes/correct, no/wrong; Y N: catch trial; T: void")
        ->required();
    verb->add_flag("--json", trace_.json, "for programs");
    verb->callback([this] { chosen_ = [this] { return run_trace(trace_); }; });
  }

  void add_simulate() {
    CLI::App* verb = app_.add_subcommand("simulate", "runs simulated people, without a ball");
    verb->add_option("experiments", simulate_.experiments, "presets or files; default: all three");
    verb->add_option("--observers", simulate_.observers, "how many people")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    verb->add_option("--seed", simulate_.seed)->capture_default_str();
    verb->add_option("--threads", simulate_.threads, "default: one a core");
    verb->add_flag("--convergence", simulate_.convergence, "also where endless runs end up");
    verb->add_flag("--json", simulate_.json, "for programs");
    verb->callback([this] { chosen_ = [this] { return run_simulate(simulate_); }; });
  }

  CLI::App app_{
      "The perception experiments: how little force, and how small a difference of force "
      "or speed,\npeople feel.",
      "hedgehog-study"};
  std::function<int()> chosen_{};
  TraceOptions trace_{};
  SimulateOptions simulate_{};
};

}  // namespace

int run_command_line(int argc, const char* const* argv) { return CommandLine().run(argc, argv); }

}  // namespace hedgehog::study

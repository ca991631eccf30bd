// SPDX-License-Identifier: MIT
// Measures the daemon against reference programs, or against another revision, in rounds.
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "base/wall_time.h"
#include "cli/program.h"
#include "tests/bench/load/results.h"
#include "tests/bench/load/scenarios.h"

namespace {

namespace bench = hedgehog::bench;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Options {
  std::string build = (fs::read_symlink("/proc/self/exe").parent_path() / "../..").string();
  std::string other;
  std::string revision = "other";
  std::string out;
  std::string only;
  std::string commit;
  std::string functions;
  int rounds = 7;
  double seconds = 1.0;
  double limit_s = 420.0;
  std::size_t subscribers = 1000;
  bool json = false;
};

void add_options(const hedgehog::cli::CommandSpec& app, Options& options) {
  app.add_option("--rounds", options.rounds, "How often everything is measured").range(1, 1000);
  app.add_option("--seconds", options.seconds, "Of one measurement").range(0.01, 60.0);
  app.add_option("--limit", options.limit_s,
                 "No round begins that would end after so many seconds");
  app.add_option("--subscribers", options.subscribers).range(1, 1000);
  app.add_option("--only", options.only, "Only scenarios whose name has this");
  app.add_option("--build", options.build, "Build folder with the daemon");
  app.add_option("--other", options.other, "Compare with the daemon of this build folder");
  app.add_option("--revision", options.revision, "What the table calls it");
  app.add_option("--out", options.out, "Write the figures to this file, as JSON");
  app.add_option("--commit", options.commit, "What the figures are of, for the JSON");
  app.add_option("--functions", options.functions,
                 "Folder with the JSON of Google Benchmark, which is added");
  app.add_flag("--json", options.json, "Print them so, instead of a table");
}

bench::Run run_of(const Options& options, std::size_t rounds) {
  utsname system{};
  ::uname(&system);
  return {.rounds = rounds,
          .seconds = options.seconds,
          .commit = options.commit,
          .date = hedgehog::base::rfc3339(hedgehog::base::unix_ms_now()),
          .machine = std::string(system.sysname) + ' ' + system.release + ' ' + system.machine +
                     ", " + std::to_string(std::thread::hardware_concurrency()) + " processors",
          .functions = options.functions};
}

/// Each subscriber takes one socket at both ends.
void allow_many_sockets() {
  rlimit files{};
  ::getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = files.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &files);
}

/// Overwrites the previous progress text, on a terminal only.
void show_progress(const std::string& text) {
  if (::isatty(STDERR_FILENO) != 0) std::cerr << "\r\033[K" << text << std::flush;
}

/// Of fewer rounds a median says little.
constexpr int kEnough = 7;

/// A program may time out on a machine that is busy elsewhere: one retry.
constexpr int kAttempts = 2;

void measure(const bench::Scenario& scenario, const bench::Setup& setup, bench::Figures& figures) {
  for (int attempt = 1; attempt <= kAttempts; ++attempt) {
    try {
      return scenario.measure(setup, figures);
    } catch (const std::exception& e) {
      std::cerr << "bench: " << scenario.name << ": " << e.what() << '\n';
    }
  }
}

/// Runs other and own alternately, so that both are measured under the same load of the machine.
void compare(const bench::Scenario& scenario, const Options& options, const bench::Setup& setup,
             bench::Figures& figures) {
  bench::Setup own = setup;
  own.with_references = false;
  bench::Setup other = own;
  other.build = options.other;
  bench::Figures other_figures;
  bench::in_turn(setup.round, {[&] { measure(scenario, other, other_figures); },
                               [&] { measure(scenario, own, figures); }});
  for (const auto& [name, value] : other_figures.values) figures[bench::kOther + name] = value;
  for (const auto& [name, reason] : other_figures.left_out)
    figures.left_out[bench::kOther + name] = reason;
}

std::vector<bench::Figures> measure_rounds(const Options& options) {
  std::vector<bench::Figures> rounds;
  bench::Setup setup{.build = options.build,
                     .reference = options.build,
                     .seconds = options.seconds,
                     .subscribers = options.subscribers};
  const auto begun = Clock::now();
  const auto passed_s = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  for (double longest_s = 0.0; setup.round < options.rounds; ++setup.round) {
    const double start_s = passed_s();
    if (!rounds.empty() && start_s + longest_s > options.limit_s) {
      std::cerr << "bench: " << rounds.size() << " rounds, for more there is no time\n";
      break;
    }
    bench::Figures& figures = rounds.emplace_back();
    for (const bench::Scenario& scenario : bench::scenarios()) {
      if (std::string(scenario.name).find(options.only) == std::string::npos) continue;
      show_progress("round " + std::to_string(setup.round + 1) + " of " +
                    std::to_string(options.rounds) + ": " + scenario.name);
      if (options.other.empty())
        measure(scenario, setup, figures);
      else
        compare(scenario, options, setup, figures);
    }
    longest_s = std::max(longest_s, passed_s() - start_s);
  }
  show_progress("");
  return rounds;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  hedgehog::cli::Program app("Measures hedgehogd beside reference programs, in rounds", "rounds");
  add_options(app, options);
  if (const auto code = app.parse_and_print(argc, argv)) return *code;
  std::signal(SIGPIPE, SIG_IGN);
  allow_many_sockets();
  const std::vector<bench::Figures> rounds = measure_rounds(options);
  const auto rows =
      options.other.empty() ? bench::reference_rows() : bench::comparison_rows(options.revision);
  std::vector<bench::Result> results = bench::results(rows, rounds);
  if (!options.only.empty())
    std::erase_if(results, [](const bench::Result& one) { return one.is_incomplete(); });
  const std::string json = bench::json_of(results, run_of(options, rounds.size()));
  std::cout << (options.json
                    ? json
                    : bench::table_of(results) + "Medians of " + std::to_string(rounds.size()) +
                          " rounds of " + std::to_string(options.rounds) + " requested.\n");
  if (!options.out.empty() && !(std::ofstream(options.out) << json)) {
    std::cerr << "bench: cannot write " << options.out << '\n';
    return EXIT_FAILURE;
  }
  const bool complete = std::none_of(results.begin(), results.end(),
                                     [](const bench::Result& one) { return one.is_incomplete(); });
  const bool enough = rounds.size() >= static_cast<std::size_t>(std::min(options.rounds, kEnough));
  return complete && enough && !results.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-License-Identifier: MIT
// Hours of random requests from several clients on random balls that are healthy within their
// tolerances, and on such balls after `calibrate --thermal`: none may trip, no winding may
// pass 73.5 C, none may leave a coil driven. 10 000 h on the 20 ms step and 100 h on the 1 ms step
// are the long form; --ci is the short one.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string_view>

#include "tests/campaign/parallel.h"
#include "tests/rig/hours.h"

namespace {

using hedgehog::rig::HourResult;

struct Options {
  std::uint64_t thermal_hours = 10'000;
  std::uint64_t full_hours = 100;
  std::uint64_t calibrated_hours = 1000;
  std::uint64_t seed = 1;
  unsigned jobs = 2;
  hedgehog::device::FrontEndChoice front_end;
  /// Each ball's electronics have individual part tolerances, also in the hours of 1 ms.
  bool parts = false;
  /// Tolerance of the thermal constants, as a share; for the 20 ms hours.
  double tolerance = 0.2;
  /// Factor of each ball's thermal resistance to ambient: 2 in a closed hand.
  double hand = 1.0;
};

struct Summary {
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;
  std::uint64_t effects = 0;
  double hottest_c = 0.0;
  double skin_c = 0.0;
  double held_skin_c = 0.0;
  double derated = 0.0;
};

Summary run(const char* what, std::uint64_t hours, const Options& options,
            const std::function<HourResult(std::uint64_t)>& hour) {
  Summary summary;
  const auto seed_of = [&](std::uint64_t i) { return options.seed * 1'000'003 + i; };
  const auto run_one = [&](std::uint64_t i) { return hour(seed_of(i)); };
  const auto on_result = [&](std::uint64_t i, const HourResult& result) {
    if (result.failure.empty()) {
      ++summary.passed;
    } else {
      ++summary.failed;
      std::fprintf(stderr, "\n%s, seed %llu: %s\n", what,
                   static_cast<unsigned long long>(seed_of(i)), result.failure.c_str());
    }
    summary.effects += result.effects;
    summary.hottest_c = std::max(summary.hottest_c, result.hottest_c);
    summary.skin_c = std::max(summary.skin_c, result.skin_c);
    summary.held_skin_c = std::max(summary.held_skin_c, result.held_skin_c);
    summary.derated += result.derated;
  };
  hedgehog::campaign::run_each(what, hours, options.jobs, run_one, on_result);
  std::printf(
      "%s: %llu passed, %llu failed; %llu effects, hottest winding %.2f C, skin %.2f C"
      " (after 10 min %.2f C), derated %.1f %% of the time\n",
      what, static_cast<unsigned long long>(summary.passed),
      static_cast<unsigned long long>(summary.failed),
      static_cast<unsigned long long>(summary.effects), summary.hottest_c, summary.skin_c,
      summary.held_skin_c, hours == 0 ? 0.0 : 100.0 * summary.derated / static_cast<double>(hours));
  return summary;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const auto value = [&] { return i + 1 < argc ? std::strtoull(argv[++i], nullptr, 10) : 0; };
    if (word == "--ci") {
      options.thermal_hours = 300;
      options.full_hours = 5;
      options.calibrated_hours = 20;
    } else if (word == "--hours20ms") {
      options.thermal_hours = value();
    } else if (word == "--hours1ms") {
      options.full_hours = value();
    } else if (word == "--calibrated") {
      options.calibrated_hours = value();
    } else if (word == "--seed") {
      options.seed = value();
    } else if (word == "--jobs") {
      options.jobs = static_cast<unsigned>(std::clamp<unsigned long long>(value(), 1, 64));
    } else if (word == "--front-end" && i + 1 < argc &&
               hedgehog::device::front_end_kind(argv[i + 1])) {
      options.front_end.kind = *hedgehog::device::front_end_kind(argv[++i]);
    } else if (word == "--thermistors") {
      options.front_end.thermistors = value() == 1 ? 1 : 3;
    } else if (word == "--parts") {
      options.parts = true;
    } else if (word == "--tolerance" && i + 1 < argc) {
      options.tolerance = std::strtod(argv[++i], nullptr);
    } else if (word == "--closed-hand") {
      options.hand = 2.0;
    } else {
      std::fputs(
          "usage: campaign_random_hours [--ci] [--hours20ms N] [--hours1ms M] [--calibrated K]"
          " [--seed S] [--jobs J]\n"
          "                             [--front-end in_line|driver_cs|ideal] [--thermistors 1|3]\n"
          "                             [--tolerance S (thermal, of the 20 ms hours)]"
          " [--parts (of the 1 ms hours)] [--closed-hand]\n",
          stderr);
      return 64;
    }
  }
  const auto thermal = run(
      "20 ms hours", options.thermal_hours, options,
      [&](std::uint64_t seed) {
        return hedgehog::rig::thermal_hour(seed, 3600.0, options.front_end, options.tolerance,
                                           options.hand);
      });
  const auto calibrated =
      run("calibrated hours", options.calibrated_hours, options, [&](std::uint64_t seed) {
        return hedgehog::rig::calibrated_hour(seed, 3600.0, options.front_end);
      });
  const auto full = run("1 ms hours", options.full_hours, options, [&](std::uint64_t seed) {
    auto front_end = options.front_end;
    if (options.parts) front_end.seed = seed;
    return hedgehog::rig::full_hour(seed, 3600.0, front_end, options.hand);
  });
  const std::uint64_t passed = thermal.passed + calibrated.passed + full.passed;
  const std::uint64_t failed = thermal.failed + calibrated.failed + full.failed;
  std::printf("%llu passed, %llu failed\n", static_cast<unsigned long long>(passed),
              static_cast<unsigned long long>(failed));
  return failed == 0 ? 0 : 1;
}

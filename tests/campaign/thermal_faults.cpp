// SPDX-License-Identifier: MIT
// Balls with faults: manually chosen and random ones, in steps of 20 ms. With one thermistor no
// winding may exceed 80 C, nor 75 C for more than 10 s except in one of 1000; with one on each
// winding or with thermal constants known to 5 % none may exceed 75 C. 90 % of the stops name the
// fault. A driven line that should be idle is safe within 30 ms.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

#include "tests/campaign/parallel.h"
#include "tests/rig/fault_run.h"

namespace {

namespace rig = hedgehog::rig;

struct Options {
  std::uint64_t random = 10'000;
  /// Runs every Nth of the manually chosen faults.
  std::uint64_t every = 1;
  std::uint64_t seed = 1;
  unsigned jobs = 2;
  double tolerance = 0.2;
  hedgehog::device::FrontEndChoice front_end;
  bool verbose = false;
};

struct Summary {
  int count = 0;
  int stopped = 0;
  int named = 0;
  int above_75 = 0;
  int long_above_75 = 0;
  int above_80 = 0;
  int long_driven = 0;
  /// Of the faults that hide heat.
  int hiding_stopped = 0;
  int hiding_detected = 0;
  double hottest_c = 0.0;

  void add(const rig::ThermalFault& fault, const rig::FaultResult& result) {
    ++count;
    stopped += result.stop.any();
    named += result.stop.any() && rig::named(fault, result.stop);
    if (rig::hides_heat(fault.error)) {
      hiding_stopped += result.stop.any();
      hiding_detected += result.stop.any() && rig::named(fault, result.stop);
    }
    above_75 += result.hottest_c > 75.0;
    long_above_75 += result.above_75_s > 10.0;
    above_80 += result.hottest_c > 80.0;
    long_driven += result.driven_ms > rig::kMaxDrivenMs;
    hottest_c = std::max(hottest_c, result.hottest_c);
  }
};

void print(const char* what, const Summary& s) {
  std::printf("%-22s %6d %8.1f %6d %6d %6d %6d %8d %7.0f %%\n", what, s.count, s.hottest_c,
              s.above_75, s.long_above_75, s.above_80, s.long_driven, s.stopped,
              s.stopped > 0 ? 100.0 * s.named / s.stopped : 100.0);
}

/// Runs `count` faults, given by `fault_of`, and adds them up by kind.
template <class FaultOf>
Summary run(const char* what, std::uint64_t count, const Options& options, FaultOf fault_of) {
  std::map<std::string_view, Summary> kinds;
  Summary all;
  struct Run {
    rig::ThermalFault fault;
    rig::FaultResult result;
  };
  const auto run_one = [&](std::uint64_t i) {
    const rig::RandomFault one = fault_of(i);
    return Run{one.fault, rig::run_fault(one.fault, one.ball)};
  };
  hedgehog::campaign::run_each(
      what, count, options.jobs, run_one, [&](std::uint64_t i, const Run& r) {
        const auto& [fault, result] = r;
        all.add(fault, result);
        kinds[name(fault.error.kind)].add(fault, result);
        const bool wrong_reason = result.stop.any() && !rig::named(fault, result.stop);
        if (result.hottest_c > 75.0 || result.driven_ms > rig::kMaxDrivenMs ||
            (options.verbose && wrong_reason)) {
          std::fprintf(stderr, "\n%s %llu, %s: %.1f C, above 75 for %.1f s, %s\n", what,
                       static_cast<unsigned long long>(i), words(fault).c_str(), result.hottest_c,
                       result.above_75_s, words(result.stop).c_str());
        }
      });
  std::printf("%-22s  count  hottest   > 75  > 10 s   > 80 >30 ms  stopped    named\n", what);
  for (const auto& [kind, summary] : kinds) print(std::string(kind).c_str(), summary);
  print("all", all);
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const auto value = [&] { return i + 1 < argc ? std::strtoull(argv[++i], nullptr, 10) : 0; };
    if (word == "--ci") {
      options.random = 300;
    } else if (word == "--random") {
      options.random = value();
    } else if (word == "--every") {
      options.every = std::max(1ULL, value());
    } else if (word == "--seed") {
      options.seed = value();
    } else if (word == "--jobs") {
      options.jobs = static_cast<unsigned>(std::clamp<unsigned long long>(value(), 1, 64));
    } else if (word == "--front-end" && i + 1 < argc &&
               hedgehog::device::front_end_kind(argv[i + 1])) {
      options.front_end.kind = *hedgehog::device::front_end_kind(argv[++i]);
    } else if (word == "--thermistors") {
      options.front_end.thermistors = value() == 1 ? 1 : 3;
    } else if (word == "--tolerance" && i + 1 < argc) {
      options.tolerance = std::strtod(argv[++i], nullptr);
    } else if (word == "--verbose") {
      options.verbose = true;
    } else {
      std::fputs(
          "usage: campaign_thermal_faults [--ci] [--every N] [--random N] [--seed S] [--jobs J]\n"
          "                               [--verbose] [--front-end in_line|driver_cs|ideal]"
          " [--thermistors 1|3] [--tolerance S]\n",
          stderr);
      return 64;
    }
  }
  const auto by_hand = rig::thermal_faults(options.front_end);
  const Summary made = run(
      "by hand", (by_hand.size() + options.every - 1) / options.every, options,
      [&](std::uint64_t i) {
        const rig::ThermalFault& fault = by_hand[i * options.every];
        rig::RandomFault one{fault, rig::matching_ball(fault, options.front_end)};
        one.ball.uncertainty.thermal = options.tolerance;
        return one;
      });
  const Summary random = run("random", options.random, options, [&](std::uint64_t i) {
    return rig::random_fault(options.seed * 1'000'003 + i, options.front_end, options.tolerance);
  });
  const bool well_known =
      options.front_end.parameters().wiring.thermistors > 1 || options.tolerance <= 0.05;
  bool held = made.above_80 + random.above_80 == 0;
  held = held && 1000 * random.long_above_75 <= random.count && made.long_above_75 == 0;
  if (well_known) held = held && made.above_75 + random.above_75 == 0;
  held = held && made.long_driven + random.long_driven == 0;
  const int stopped = made.stopped + random.stopped;
  const int hiding = made.hiding_stopped + random.hiding_stopped;
  held = held && 10 * (made.named + random.named) >= 9 * stopped;
  held = held && 10 * (made.hiding_detected + random.hiding_detected) >= 9 * hiding;
  std::printf("named: %.1f %% of all that stopped, %.1f %% of those that hide heat\n",
              100.0 * (made.named + random.named) / std::max(1, stopped),
              100.0 * (made.hiding_detected + random.hiding_detected) / std::max(1, hiding));
  std::puts(held ? "held" : "NOT held");
  return held ? 0 : 1;
}

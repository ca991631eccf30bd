// SPDX-License-Identifier: MIT
// Hours of random requests from several clients on random balls: none may trip, no winding may pass
// 73.5 C, none may leave a coil driven. 10 000 h on the 20 ms step and 100 h on the 1 ms step are
// the long form; --ci is the short one.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/rig/hours.h"

namespace {

using hedgehog::rig::HourResult;

struct Options {
  std::uint64_t thermal_hours = 10'000;
  std::uint64_t full_hours = 100;
  std::uint64_t seed = 1;
  unsigned jobs = 2;
};

struct Summary {
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;
  std::uint64_t effects = 0;
  double hottest_c = 0.0;
  double derated = 0.0;
};

void show_progress(const char* what, std::uint64_t done, std::uint64_t all) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  constexpr int kWidth = 40;
  if (terminal) {
    const int full = static_cast<int>(kWidth * done / all);
    std::fprintf(stderr, "\r%s [%.*s%*s] %llu/%llu", what, full,
                 "########################################", kWidth - full, "",
                 static_cast<unsigned long long>(done), static_cast<unsigned long long>(all));
    if (done == all) std::fputc('\n', stderr);
  } else if (done == all || done % std::max<std::uint64_t>(1, all / 10) == 0) {
    std::fprintf(stderr, "%s %llu/%llu\n", what, static_cast<unsigned long long>(done),
                 static_cast<unsigned long long>(all));
  }
}

Summary run(const char* what, std::uint64_t hours, const Options& options,
            const std::function<HourResult(std::uint64_t)>& hour) {
  Summary summary;
  std::atomic<std::uint64_t> next{0};
  std::mutex mutex;
  const auto work = [&] {
    for (std::uint64_t i = next++; i < hours; i = next++) {
      const std::uint64_t seed = options.seed * 1'000'003 + i;
      const HourResult result = hour(seed);
      const std::lock_guard lock(mutex);
      if (result.failure.empty()) {
        ++summary.passed;
      } else {
        ++summary.failed;
        std::fprintf(stderr, "\n%s, seed %llu: %s\n", what, static_cast<unsigned long long>(seed),
                     result.failure.c_str());
      }
      summary.effects += result.effects;
      summary.hottest_c = std::max(summary.hottest_c, result.hottest_c);
      summary.derated += result.derated;
      show_progress(what, summary.passed + summary.failed, hours);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < options.jobs; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  std::printf(
      "%s: %llu passed, %llu failed; %llu effects, hottest winding %.2f C, derated %.1f %%"
      " of the time\n",
      what, static_cast<unsigned long long>(summary.passed),
      static_cast<unsigned long long>(summary.failed),
      static_cast<unsigned long long>(summary.effects), summary.hottest_c,
      hours == 0 ? 0.0 : 100.0 * summary.derated / static_cast<double>(hours));
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
    } else if (word == "--hours20ms") {
      options.thermal_hours = value();
    } else if (word == "--hours1ms") {
      options.full_hours = value();
    } else if (word == "--seed") {
      options.seed = value();
    } else if (word == "--jobs") {
      options.jobs = static_cast<unsigned>(std::clamp<unsigned long long>(value(), 1, 64));
    } else {
      std::fputs(
          "usage: campaign_random_hours [--ci] [--hours20ms N] [--hours1ms M] [--seed S]"
          " [--jobs J]\n",
          stderr);
      return 64;
    }
  }
  const auto thermal = run("20 ms hours", options.thermal_hours, options,
                           [](std::uint64_t seed) { return hedgehog::rig::thermal_hour(seed); });
  const auto full = run("1 ms hours", options.full_hours, options,
                        [](std::uint64_t seed) { return hedgehog::rig::full_hour(seed); });
  const std::uint64_t passed = thermal.passed + full.passed;
  const std::uint64_t failed = thermal.failed + full.failed;
  std::printf("%llu passed, %llu failed\n", static_cast<unsigned long long>(passed),
              static_cast<unsigned long long>(failed));
  return failed == 0 ? 0 : 1;
}

// SPDX-License-Identifier: MIT
// The short form: a few hundred actions with a fixed seed and with the seed of the day.
#include "tests/soak/soak.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <iostream>

namespace hedgehog::soak {
namespace {

constexpr std::uint64_t kFixedSeed = 1;

std::uint64_t seed_of_the_day() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return 1'000'000 + static_cast<std::uint64_t>(
                         std::chrono::duration_cast<std::chrono::hours>(now).count() / 24);
}

class Soak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Soak, EveryRequestIsAnsweredAndNothingIsLeftUnderRandomClients) {
  Summary summary;
  std::cout << "seed " << GetParam()
            << (may_mount() ? "" : "; no full disks: this user may not mount one") << "\n";
  const std::string failure = run_soak(
      {.seed = GetParam(), .rounds = 1, .size = {.starts = 3, .actions = 200}}, summary, [] {});
  EXPECT_EQ(failure, "") << "again: test_soak, or make soak ARGS=\"--rounds 1 --starts 3 --actions "
                            "200 --seed N\" with the seed above";
  std::cout << summary.text();
}

INSTANTIATE_TEST_SUITE_P(Seed, Soak, testing::Values(kFixedSeed, seed_of_the_day()),
                         [](const auto& info) { return info.index == 0 ? "Fixed" : "OfTheDay"; });

}  // namespace
}  // namespace hedgehog::soak

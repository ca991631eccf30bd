// SPDX-License-Identifier: MIT
// Runs rounds one after the other.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "tests/soak/round.h"
#include "tests/soak/summary.h"

namespace hedgehog::soak {

struct SoakOptions {
  std::uint64_t seed = 1;  // seed of the first round; incremented by 1 for each further one
  std::uint64_t rounds = 1;
  /// No further round begins after this time; 0: only `rounds` counts.
  std::chrono::seconds duration{0};
  RoundSize size{};
};

/// Empty, or the failure with the seed of its round. `on_round` is called after each round.
std::string run_soak(const SoakOptions& options, Summary& summary,
                     const std::function<void()>& on_round);

}  // namespace hedgehog::soak

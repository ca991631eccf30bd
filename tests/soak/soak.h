// SPDX-License-Identifier: MIT
// Rounds one after the other.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "tests/soak/round.h"
#include "tests/soak/summary.h"

namespace hedgehog::soak {

struct SoakOptions {
  std::uint64_t seed = 1;  // of the first round; each further one has the next
  std::uint64_t rounds = 1;
  /// No further round begins after it; 0: only `rounds` count.
  std::chrono::seconds duration{0};
  RoundSize size{};
};

/// Empty, or the failure with the seed of its round. `on_round` is called after each.
std::string run_soak(const SoakOptions& options, Summary& summary,
                     const std::function<void()>& on_round);

}  // namespace hedgehog::soak

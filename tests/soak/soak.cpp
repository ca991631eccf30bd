// SPDX-License-Identifier: MIT
#include "tests/soak/soak.h"

#include <exception>

namespace hedgehog::soak {

std::string run_soak(const SoakOptions& options, Summary& summary,
                     const std::function<void()>& on_round) {
  const auto end = std::chrono::steady_clock::now() + options.duration;
  const bool is_timed = options.duration.count() > 0;
  for (std::uint64_t i = 0; is_timed ? std::chrono::steady_clock::now() < end : i < options.rounds;
       ++i) {
    const std::uint64_t seed = options.seed + i;
    try {
      Round(seed, options.size, summary).run();
    } catch (const std::exception& e) {
      return "seed " + std::to_string(seed) + ": " + e.what();
    }
    on_round();
  }
  return {};
}

}  // namespace hedgehog::soak

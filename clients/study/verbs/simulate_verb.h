// SPDX-License-Identifier: MIT
// `simulate`: simulated people in an experiment.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hedgehog::study {

struct SimulateOptions {
  std::vector<std::string> experiments{};  // empty: the thesis' three
  int observers = 2000;
  std::uint64_t seed = 2026;
  int threads = 0;  // 0: the number of cores
  bool convergence = false;
  bool json = false;
};

int run_simulate(const SimulateOptions& options);

}  // namespace hedgehog::study

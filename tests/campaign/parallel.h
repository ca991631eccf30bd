// SPDX-License-Identifier: MIT
// Runs a campaign in parallel, and reports its progress.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/campaign/progress.h"

namespace hedgehog::campaign {

/// Calls `run(i)` for each i below `count` on `jobs` threads, and `on_result(i, result)` with each
/// result, one at a time and in any order.
template <class Run, class OnResult>
void run_each(const char* what, std::uint64_t count, unsigned jobs, const Run& run,
              const OnResult& on_result) {
  std::atomic<std::uint64_t> next{0};
  std::uint64_t done = 0;
  std::mutex mutex;
  const auto work = [&] {
    for (std::uint64_t i = next++; i < count; i = next++) {
      const auto result = run(i);
      const std::lock_guard lock(mutex);
      on_result(i, result);
      show_progress(what, ++done, count);
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < jobs; ++i) threads.emplace_back(work);
}

}  // namespace hedgehog::campaign

// SPDX-License-Identifier: MIT
// Execution of independent work items by several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace hedgehog::design {

/// Calls `work(0)` to `work(count - 1)`, each once, on `threads` threads (at least 1), in any
/// order; `progress(done)` every 100 ms and at the end, on the calling thread. Returns when all are
/// done. The first exception of an item is rethrown once all threads have ended.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& progress);

}  // namespace hedgehog::design

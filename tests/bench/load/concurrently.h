// SPDX-License-Identifier: MIT
// Runs a load concurrently with a measurement.
#pragma once

#include <future>
#include <utility>

namespace hedgehog::bench {

/// `measure` in this thread while `load` runs in another. Returns when both have ended; throws what
/// either threw.
template <class Load, class Measure>
void concurrently(Load load, Measure measure) {
  std::future<void> loaded = std::async(std::launch::async, std::move(load));
  measure();
  loaded.get();
}

}  // namespace hedgehog::bench

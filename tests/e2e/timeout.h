// SPDX-License-Identifier: MIT
// How long a test waits for an expected event on a busy machine. No test asserts these times.
#pragma once

#include <chrono>
#include <thread>

namespace hedgehog::e2e {

inline constexpr std::chrono::seconds kTimeout{60};
/// For a whole program or a long step of one, or for one message among others that keep arriving.
inline constexpr std::chrono::seconds kLongTimeout{600};

/// Polls `done` every 5 ms; false when it was not true within `timeout`.
template <class Done>
bool wait_until(Done done, std::chrono::seconds timeout = kTimeout) {
  constexpr std::chrono::milliseconds kStep{5};
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (!done()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(kStep);
  }
  return true;
}

}  // namespace hedgehog::e2e

// SPDX-License-Identifier: MIT
// Sleep until a point of CLOCK_MONOTONIC, for the threads that run the controller. Linux.
#pragma once

#include <cerrno>
#include <cstdint>
#include <ctime>

namespace hedgehog::control {

/// Any thread. Returns at once if `ns` is past.
inline void sleep_until_ns(std::int64_t ns) noexcept {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const timespec until{ns / kSecond, ns % kSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace hedgehog::control

// SPDX-License-Identifier: MIT
// Pause before the next attempt to reconnect: 0.1 s, doubled each time, at most 5 s.
#pragma once

#include <algorithm>
#include <chrono>

namespace hedgehog::client {

class Backoff {
 public:
  using Milliseconds = std::chrono::milliseconds;
  static constexpr Milliseconds kFirst{100};
  static constexpr Milliseconds kMaxPause{5000};

  /// The pause before the next attempt.
  Milliseconds next() noexcept {
    const Milliseconds pause = pause_;
    pause_ = std::min(2 * pause_, kMaxPause);
    return pause;
  }
  /// After a success.
  void reset() noexcept { pause_ = kFirst; }

 private:
  Milliseconds pause_ = kFirst;
};

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// A condition that counts once it has held without interruption for some milliseconds.
#pragma once

#include <stdint.h>

namespace hedgehog::board {

class Persistence {
 public:
  explicit constexpr Persistence(uint32_t needed_ms) noexcept : needed_ms_(needed_ms) {}

  /// Advances by one millisecond; true after `needed_ms`, for as long as the condition holds.
  bool step(bool condition) noexcept {
    if (!condition)
      held_ms_ = 0;
    else if (held_ms_ < needed_ms_)
      ++held_ms_;
    return condition && held_ms_ >= needed_ms_;
  }

 private:
  uint32_t needed_ms_;
  uint32_t held_ms_ = 0;
};

}  // namespace hedgehog::board

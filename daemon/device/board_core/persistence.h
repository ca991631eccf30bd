// SPDX-License-Identifier: MIT
// A condition that counts only once it has held without a gap for some milliseconds.
#pragma once

#include <stdint.h>

namespace hedgehog::board {

class Persistence {
 public:
  explicit constexpr Persistence(uint32_t needed_ms) noexcept : needed_ms_(needed_ms) {}

  /// One millisecond; true from the needed one on, for as long as the condition holds.
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

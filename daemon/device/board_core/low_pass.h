// SPDX-License-Identifier: MIT
// Exponential mean of a current over a power of two of milliseconds.
#pragma once

#include <stdint.h>

namespace hedgehog::board {

class LowPass {
 public:
  /// Time constant: 2^shift ms, `shift` at most 14.
  explicit constexpr LowPass(int shift) noexcept : shift_(shift) {}

  /// Advances by one millisecond. REQUIRES: ma <= 2^17.
  void step(uint32_t ma) noexcept { sum_ = sum_ - (sum_ >> shift_) + ma; }
  uint32_t mean_ma() const noexcept { return sum_ >> shift_; }

 private:
  uint32_t sum_ = 0;
  int shift_;
};

}  // namespace hedgehog::board

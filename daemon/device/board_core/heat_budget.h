// SPDX-License-Identifier: MIT
// Leaky sum of squared current: thermal limit of a winding whose temperature is unknown.
#pragma once

#include <stdint.h>

namespace hedgehog::board {

/// q in mA^2 ms. dq/dt = I^2 - q / tau with tau = 2^shift ms.
class HeatBudget {
 public:
  explicit constexpr HeatBudget(int tau_shift) noexcept : tau_shift_(tau_shift) {}

  /// Adds one millisecond with this squared current.
  void step(uint32_t squared_ma2) noexcept { sum_ = sum_ - (sum_ >> tau_shift_) + squared_ma2; }

  /// True when the sum has reached `budget_a2s` A^2 s, then until it is below 7/8 of it, so that
  /// arming does not cause repeated trips.
  bool exceeded(uint32_t budget_a2s) noexcept {
    const uint64_t budget = scaled(budget_a2s);
    exceeded_ = sum_ >= budget || (exceeded_ && sum_ >= budget - budget / 8);
    return exceeded_;
  }

  /// Thousandths of `budget_a2s`, at most 65535.
  uint16_t permille(uint32_t budget_a2s) const noexcept {
    const uint64_t unit = scaled(budget_a2s) / 1000u;
    const uint64_t share = unit == 0 ? 65535u : sum_ / unit;
    return static_cast<uint16_t>(share > 65535u ? 65535u : share);
  }

 private:
  // 1 A^2 s = 10^6 mA^2 x 10^3 ms.
  static constexpr uint64_t scaled(uint32_t a2s) noexcept { return a2s * uint64_t{1000000000}; }

  uint64_t sum_ = 0;
  int tau_shift_;
  bool exceeded_ = false;
};

}  // namespace hedgehog::board

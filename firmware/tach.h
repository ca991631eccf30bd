// SPDX-License-Identifier: MIT
// The fan's tach: falling edges, two a turn, latched by the pin's own detector (data sheet 2.19.3).
#pragma once

#include "firmware/pins.h"
#include "firmware/registers.h"

namespace hedgehog::firmware {

class Tach {
 public:
  void start() noexcept {
    reg(kEdges) = kFallingEdge;
    reg(kEnabledEdges) = kFallingEdge;
  }

  /// Whenever the loop wakes: an edge is known as exactly as this is called.
  void poll() noexcept {
    if ((reg(kEdges) & kFallingEdge) == 0) return;
    reg(kEdges) = kFallingEdge;
    const uint32_t now = now_us();
    const uint32_t period = now - last_us_;
    if (period < kShortestUs) return;
    period_us_ = turning_ ? period : 0;
    last_us_ = now;
    turning_ = true;
  }

  /// Microseconds between the last two edges; 0: none for 250 ms.
  uint32_t period_us() noexcept {
    if (turning_ && now_us() - last_us_ > kLongestUs) {
      turning_ = false;
      period_us_ = 0;
    }
    return period_us_;
  }

 private:
  // Pin 11 is in the second register of eight pins each.
  static constexpr uint32_t kEdges = kIoBank0 + 0xF4;
  static constexpr uint32_t kEnabledEdges = kIoBank0 + 0x104;
  static constexpr uint32_t kFallingEdge = 1u << (4 * (kTachPin - 8) + 2);
  /// 20000 turns a minute: less is a contact that bounces.
  static constexpr uint32_t kShortestUs = 1500;
  static constexpr uint32_t kLongestUs = 250'000;

  uint32_t last_us_ = 0;
  uint32_t period_us_ = 0;
  bool turning_ = false;
};

}  // namespace hedgehog::firmware

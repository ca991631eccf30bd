// SPDX-License-Identifier: MIT
// Deterministic random numbers for simulations: the same seed gives the same stream on every
// machine, and the state is one word that can be recorded.
#pragma once

#include <cstdint>

namespace hedgehog::model {

/// SplitMix64 (Steele, Lea and Flood 2014). Not cryptographically secure. Trivially copyable.
class RandomStream {
 public:
  constexpr RandomStream() noexcept = default;
  constexpr explicit RandomStream(std::uint64_t seed) noexcept : state_(seed) {}

  constexpr std::uint64_t bits() noexcept {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// Uniform in [low, high).
  constexpr double uniform(double low, double high) noexcept {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1.0p-53;
  }

  /// Mean 0, standard deviation 1: the sum of twelve 16-bit uniforms, so within +-6.
  constexpr double gaussian() noexcept {
    std::uint64_t sum = 0;
    for (int word = 0; word < 3; ++word) {
      const std::uint64_t z = bits();
      sum += (z & 0xFFFFu) + ((z >> 16) & 0xFFFFu) + ((z >> 32) & 0xFFFFu) + (z >> 48);
    }
    return static_cast<double>(sum) * 0x1.0p-16 - 6.0 + 12.0 * 0x1.0p-17;
  }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace hedgehog::model

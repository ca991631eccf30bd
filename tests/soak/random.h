// SPDX-License-Identifier: MIT
// Random decisions, identical for a seed on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace hedgehog::soak {

/// Does not use the distributions of the standard library: they differ between its implementations,
/// the engine does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// 0 to `count` - 1. REQUIRES: count > 0
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  /// `low` to `high`, both included.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool percent(int chance) { return below(100) < static_cast<std::size_t>(chance); }
  /// 0 to 1.
  double unit() { return static_cast<double>(below(1'000'001)) / 1e6; }
  template <class List>
  const auto& pick(const List& list) {
    return list[below(std::size(list))];
  }
  std::string bytes(std::size_t count) {
    std::string made(count, '\0');
    for (char& c : made) c = static_cast<char>(below(256));
    return made;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace hedgehog::soak

// SPDX-License-Identifier: MIT
// Random draws by hash instead of a sequence: each depends only on its purpose and index, so that a
// void trial, a kill or a new kind of draw does not shift any other.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace hedgehog::study {

/// Purpose of a draw. Values are part of recorded data: never renumber.
enum class Purpose : std::uint64_t {
  kSeed = 1,           // a seed derived from a seed
  kIntervalOrder = 2,  // which interval contains the test
  kCatchSchedule = 3,  // whether a catch trial comes before this scored trial
  kAnswer = 4,         // response of a simulated person
  kPerson = 5,         // parameters of a simulated person
  kReactionTime = 6,   // 7 was used for replications of earlier intervals
};

constexpr std::uint64_t mixed(std::uint64_t z) noexcept {
  // The finisher of SplitMix64 (Steele, Lea and Flood 2014).
  z += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// FNV-1a, to use names in draws.
constexpr std::uint64_t word_of(std::string_view text) noexcept {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  return hash;
}

constexpr std::uint64_t draw_bits(std::uint64_t seed, Purpose purpose,
                                  std::initializer_list<std::uint64_t> words) noexcept {
  std::uint64_t hash = mixed(mixed(seed) ^ static_cast<std::uint64_t>(purpose));
  for (const std::uint64_t word : words) hash = mixed(hash ^ mixed(word));
  return hash;
}

/// Uniform in [0, 1).
constexpr double draw(std::uint64_t seed, Purpose purpose,
                      std::initializer_list<std::uint64_t> words) noexcept {
  return static_cast<double>(draw_bits(seed, purpose, words) >> 11) * 0x1.0p-53;
}

}  // namespace hedgehog::study

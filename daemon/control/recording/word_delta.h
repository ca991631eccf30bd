// SPDX-License-Identifier: MIT
// Delta encoding of a value that changes little from tick to tick, by 64-bit words.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace hedgehog::control {

/// Format: a mask of 64 bits, then the 64-bit words of T whose bits are set in it. Encoder and
/// decoder each keep the last value, zero initially and after `restart`. Real-time safe.
template <class T>
class WordDelta {
 public:
  static constexpr std::size_t kMaxBytes = sizeof(std::uint64_t) + sizeof(T);

  /// Returns the number of bytes written to `out`.
  std::size_t encode(const T& value, std::span<std::byte, kMaxBytes> out) noexcept {
    Words words;
    std::memcpy(words.data(), &value, sizeof value);
    std::uint64_t changed = 0;
    std::byte* to = out.data() + sizeof changed;
    for (std::size_t i = 0; i < kWords; ++i) {
      if (words[i] == last_[i]) continue;
      changed |= std::uint64_t{1} << i;
      std::memcpy(to, &words[i], sizeof words[i]);
      to += sizeof words[i];
    }
    std::memcpy(out.data(), &changed, sizeof changed);
    last_ = words;
    return static_cast<std::size_t>(to - out.data());
  }

  /// Returns the number of bytes read; 0 if there are too few or they do not encode a T.
  std::size_t decode(std::span<const std::byte> bytes, T& value) noexcept {
    std::uint64_t changed = 0;
    if (bytes.size() < sizeof changed) return 0;
    std::memcpy(&changed, bytes.data(), sizeof changed);
    const std::size_t used =
        sizeof changed * (1 + static_cast<std::size_t>(std::popcount(changed)));
    if (std::bit_width(changed) > static_cast<int>(kWords) || bytes.size() < used) return 0;
    const std::byte* from = bytes.data() + sizeof changed;
    for (std::size_t i = 0; i < kWords; ++i) {
      if ((changed >> i & 1) == 0) continue;
      std::memcpy(&last_[i], from, sizeof last_[i]);
      from += sizeof last_[i];
    }
    std::memcpy(static_cast<void*>(&value), last_.data(), sizeof value);
    return used;
  }

  void restart() noexcept { last_ = {}; }

 private:
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::uint64_t) == 0 &&
                sizeof(T) <= 64 * sizeof(std::uint64_t));
  static constexpr std::size_t kWords = sizeof(T) / sizeof(std::uint64_t);
  using Words = std::array<std::uint64_t, kWords>;

  Words last_{};
};

}  // namespace hedgehog::control

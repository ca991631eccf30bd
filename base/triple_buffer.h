// SPDX-License-Identifier: MIT
// Passes the latest value from one writer thread to one reader thread, lock-free and wait-free.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace hedgehog::base {

/// One writer, one reader; both real-time safe. A value overwritten before it was read is lost: use
/// a queue if every value matters.
template <class T>
class TripleBuffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Writer thread only.
  void write(const T& value) noexcept {
    slots_[writing_] = value;
    writing_ =
        shared_.exchange(static_cast<std::uint8_t>(writing_ | kFresh), std::memory_order_acq_rel) &
        kIndex;
  }

  /// Reader thread only. The latest value; the previous one if nothing new was written.
  const T& read() noexcept {
    fresh_ = (shared_.load(std::memory_order_relaxed) & kFresh) != 0;
    if (fresh_) reading_ = shared_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return slots_[reading_];
  }

  /// Reader thread only: true if the last `read` returned a new value.
  bool was_fresh() const noexcept { return fresh_; }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kFresh = 4;

  std::array<T, 3> slots_{};
  alignas(64) std::atomic<std::uint8_t> shared_{1};
  alignas(64) std::uint8_t writing_ = 0;
  alignas(64) std::uint8_t reading_ = 2;
  bool fresh_ = false;
};

}  // namespace hedgehog::base

// SPDX-License-Identifier: MIT
// The events of one tick in chronological order. Fixed capacity, so that the control thread may
// fill it.
#pragma once

#include <array>
#include <cstddef>

#include "daemon/control/state/event.h"

namespace hedgehog::control {

/// Not thread-safe; control thread only. Real-time safe.
class EventList {
 public:
  /// Capacity for the end of every place, for start and end of one more per command of the tick,
  /// and for the other events of a tick.
  static constexpr std::size_t kCapacity =
      std::size_t{kEffectPlaces} + 2 * std::size_t{kMaxCommandsPerTick} + 32;

  void clear() noexcept { count_ = 0; }
  /// Drops events beyond the capacity, which a tick never exceeds.
  void push(const Event& event) noexcept {
    if (count_ < kCapacity) {
      events_[count_] = event;
      ++count_;
    }
  }

  std::size_t size() const noexcept { return count_; }
  bool empty() const noexcept { return count_ == 0; }
  const Event& operator[](std::size_t i) const noexcept { return events_[i]; }
  const Event* begin() const noexcept { return events_.data(); }
  const Event* end() const noexcept { return events_.data() + count_; }

 private:
  std::size_t count_ = 0;
  std::array<Event, kCapacity> events_{};
};

}  // namespace hedgehog::control

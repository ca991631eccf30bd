// SPDX-License-Identifier: MIT
// The newest events in a few lines; frequent events do not displace important ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "clients/ctl/events/event_series.h"

namespace hedgehog::client {

/// One line per series of recurring events. A line each is reserved for the newest event that
/// switched the coils off (a trip, an emergency stop, another disarming, the loss of the ball) and
/// for the newest of derating. Bounded memory. One thread.
class RecentEvents {
 public:
  static constexpr std::size_t kMinLines = 3;
  static constexpr std::size_t kMaxLines = 32;

  /// `clock` is the local time of day, "14:03:21".
  void take(const protocol::Event& event, const std::string& clock);

  /// At most `count` lines (`kMinLines`..`kMaxLines`), newest first.
  std::vector<std::string> lines(std::size_t count) const;

 private:
  struct Entry {
    std::uint64_t number = 0;  // of the last event of the series
    EventSeries series;
  };
  /// Newest first.
  using Entries = std::deque<Entry>;
  enum Kind : std::size_t { kCoilsOff, kDerating, kOther, kKinds };

  static Kind kind_of(const protocol::Event& event) noexcept;

  std::array<Entries, kKinds> kinds_;
  std::uint64_t events_ = 0;
};

}  // namespace hedgehog::client

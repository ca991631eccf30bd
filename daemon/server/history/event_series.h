// SPDX-License-Identifier: MIT
// Events that recur while something goes on, such as a machine that is too busy, as one: the first
// of them, how many there were, and when the last was. Otherwise they would displace everything
// else from a list that is bounded.
#pragma once

#include <cstdint>

#include "protocol/methods.h"

namespace hedgehog::server {

/// io thread only.
class EventSeries {
 public:
  /// What comes later than this after the last one is something new.
  static constexpr std::int64_t kMaxGapMs = protocol::kSeriesMaxGapMs;
  /// Maximum length of a series.
  static constexpr std::int64_t kMaxMs = protocol::kSeriesMaxMs;
  /// How often one that goes on is written again.
  static constexpr std::int64_t kWriteEveryMs = 600'000;

  /// `event`: of `unix_ms`, perhaps a series itself. `number`: of the entry that it is kept as.
  EventSeries(protocol::PastEvent event, std::int64_t unix_ms, std::uint64_t number);

  /// Adds one of the same type at `unix_ms`; false: it does not belong to this series.
  bool add(const protocol::PastEvent& next, std::int64_t unix_ms);
  /// It has grown since it was written, and is over or not written for long (or `at_once`); then it
  /// counts as written.
  bool take_due(std::int64_t unix_ms, bool at_once) noexcept;

  std::uint64_t number() const noexcept { return number_; }
  std::int64_t last_ms() const noexcept { return last_ms_; }
  const protocol::PastEvent& event() const noexcept { return event_; }

 private:
  protocol::PastEvent event_;
  std::uint64_t number_ = 0;
  std::int64_t first_ms_ = 0;
  std::int64_t last_ms_ = 0;
  std::int64_t written_ms_ = 0;
  bool changed_ = false;
};

/// When the last event of `past` was, ms since 1970; `first_ms` when it is no series.
std::int64_t last_ms_of(const protocol::PastEvent& past, std::int64_t first_ms);

}  // namespace hedgehog::server

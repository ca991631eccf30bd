// SPDX-License-Identifier: MIT
// Recurring events, such as overruns under load, as one: the first, their number, and the time of
// the last. Otherwise they would displace all other events from a bounded list.
#pragma once

#include <cstdint>

#include "protocol/methods.h"

namespace hedgehog::server {

/// io thread only.
class EventSeries {
 public:
  static constexpr std::int64_t kMaxGapMs = protocol::kSeriesMaxGapMs;  // longer: a new series
  static constexpr std::int64_t kMaxMs = protocol::kSeriesMaxMs;        // length of a series
  static constexpr std::int64_t kWriteEveryMs = 600'000;  // rewriting of a continuing series

  /// `event`: at `unix_ms`, possibly a series itself. `number`: of its entry.
  EventSeries(protocol::PastEvent event, std::int64_t unix_ms, std::uint64_t number);

  /// Adds an event of the same type and disagreement; false: it does not belong to this series.
  bool add(const protocol::PastEvent& next, std::int64_t unix_ms);
  /// Has grown since it was written, and is over or due (or `at_once`); then counts as written.
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

/// Time of the last event of `past`, ms since 1970; `first_ms` if it is not a series.
std::int64_t last_ms_of(const protocol::PastEvent& past, std::int64_t first_ms);

}  // namespace hedgehog::server

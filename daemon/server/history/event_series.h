// SPDX-License-Identifier: MIT
// Recurring events, such as overruns of a machine under load, combined to one: the first of them,
// their number, and the time of the last. Otherwise they would displace all other events from a
// bounded list.
#pragma once

#include <cstdint>

#include "protocol/methods.h"

namespace hedgehog::server {

/// io thread only.
class EventSeries {
 public:
  /// A later event starts a new series.
  static constexpr std::int64_t kMaxGapMs = protocol::kSeriesMaxGapMs;
  /// Maximum length of a series.
  static constexpr std::int64_t kMaxMs = protocol::kSeriesMaxMs;
  /// Interval of rewriting a continuing series.
  static constexpr std::int64_t kWriteEveryMs = 600'000;

  /// `event`: at `unix_ms`, possibly a series itself. `number`: of its entry.
  EventSeries(protocol::PastEvent event, std::int64_t unix_ms, std::uint64_t number);

  /// Adds an event of the same type and disagreement at `unix_ms`; false: it does not belong to
  /// this series.
  bool add(const protocol::PastEvent& next, std::int64_t unix_ms);
  /// True if it has grown since it was written, and is over or due for rewriting (or `at_once`); it
  /// then counts as written.
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

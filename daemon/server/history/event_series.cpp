// SPDX-License-Identifier: MIT
#include "daemon/server/history/event_series.h"

#include <algorithm>
#include <utility>

#include "base/wall_time.h"

namespace hedgehog::server {

EventSeries::EventSeries(protocol::PastEvent event, std::int64_t unix_ms, std::uint64_t number)
    : event_(std::move(event)),
      number_(number),
      first_ms_(unix_ms),
      last_ms_(last_ms_of(event_, unix_ms)),
      written_ms_(unix_ms) {}

bool EventSeries::add(const protocol::PastEvent& next, std::int64_t unix_ms) {
  if (unix_ms < last_ms_ || unix_ms - last_ms_ > kMaxGapMs || unix_ms - first_ms_ > kMaxMs)
    return false;
  last_ms_ = last_ms_of(next, unix_ms);
  event_.count = event_.count.value_or(1) + next.count.value_or(1);
  event_.last = base::rfc3339(last_ms_);
  if (next.event.skipped)
    event_.event.skipped = event_.event.skipped.value_or(0) + *next.event.skipped;
  changed_ = true;
  return true;
}

bool EventSeries::take_due(std::int64_t unix_ms, bool at_once) noexcept {
  const bool over = at_once || unix_ms - last_ms_ > kMaxGapMs || unix_ms - first_ms_ > kMaxMs;
  if (!changed_ || (!over && unix_ms - written_ms_ < kWriteEveryMs)) return false;
  changed_ = false;
  written_ms_ = unix_ms;
  return true;
}

std::int64_t last_ms_of(const protocol::PastEvent& past, std::int64_t first_ms) {
  return past.last ? std::max(base::parse_rfc3339(*past.last).value_or(first_ms), first_ms)
                   : first_ms;
}

}  // namespace hedgehog::server

// SPDX-License-Identifier: MIT
#include "clients/ctl/events/event_log.h"

#include <algorithm>

namespace hedgehog::client {

std::vector<std::string> EventLog::take(const protocol::Event& event, const std::string& clock,
                                        Clock::time_point now) {
  EventSeries one(event, clock);
  if (!protocol::is_recurring(event.type)) return {one.line()};
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& other) { return other.series.is_of(event); });
  if (entry != entries_.end() && entry->series.add(event, clock)) {
    entry->is_printed = false;
    return {};
  }
  std::vector<std::string> lines;
  if (entry == entries_.end()) {
    entries_.push_back({one, now});
  } else {
    if (!entry->is_printed) lines.push_back(entry->series.line());
    *entry = {one, now};
  }
  lines.push_back(one.line());
  return lines;
}

std::vector<std::string> EventLog::due(Clock::time_point now) {
  std::vector<std::string> lines;
  for (Entry& entry : entries_) {
    if (entry.is_printed || now - entry.printed_at < kRepeatEvery) continue;
    lines.push_back(entry.series.line());
    entry.printed_at = now;
    entry.is_printed = true;
  }
  return lines;
}

std::vector<std::string> EventLog::rest() { return due(Clock::time_point::max()); }

}  // namespace hedgehog::client

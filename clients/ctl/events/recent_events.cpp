// SPDX-License-Identifier: MIT
#include "clients/ctl/events/recent_events.h"

#include <algorithm>
#include <utility>

namespace hedgehog::client {

RecentEvents::Kind RecentEvents::kind_of(const protocol::Event& event) noexcept {
  if (protocol::is_derating(event.type)) return kDerating;
  return event.state && *event.state != "armed" ? kCoilsOff : kOther;
}

void RecentEvents::take(const protocol::Event& event, const std::string& clock) {
  Entries& entries = kinds_[kind_of(event)];
  const auto series = std::find_if(entries.begin(), entries.end(),
                                   [&](Entry& entry) { return entry.series.add(event, clock); });
  Entry newest{++events_, series == entries.end() ? EventSeries(event, clock) : series->series};
  if (series != entries.end()) entries.erase(series);
  entries.push_front(std::move(newest));
  if (entries.size() > kMaxLines) entries.pop_back();
}

std::vector<std::string> RecentEvents::lines(std::size_t count) const {
  const auto is_newer = [](const Entry* a, const Entry* b) { return a->number > b->number; };
  std::vector<const Entry*> shown;
  std::vector<const Entry*> others;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    for (const Entry& entry : kinds_[kind]) {
      const bool is_reserved = kind != kOther && &entry == &kinds_[kind].front();
      (is_reserved ? shown : others).push_back(&entry);
    }
  }
  std::sort(others.begin(), others.end(), is_newer);
  const std::size_t free = std::min(others.size(), count - std::min(count, shown.size()));
  shown.insert(shown.end(), others.begin(), others.begin() + static_cast<std::ptrdiff_t>(free));
  std::sort(shown.begin(), shown.end(), is_newer);
  std::vector<std::string> lines;
  lines.reserve(shown.size());
  for (const Entry* entry : shown) lines.push_back(entry->series.line());
  return lines;
}

}  // namespace hedgehog::client

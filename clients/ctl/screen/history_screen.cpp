// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/history_screen.h"

#include "base/wall_time.h"
#include "clients/ctl/events/event_words.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

/// "23:14:04.402"
std::string clock_of(const std::string& at) {
  const auto unix_ms = base::parse_rfc3339(at);
  const std::string ms = std::to_string(1000 + unix_ms.value_or(0) % 1000).substr(1);
  return local_time(at, "%H:%M:%S") + "." + ms;
}

/// "  37 times, the last at 14:05:33.120" for recurring events stored as one.
std::string series_words(const protocol::PastEvent& past) {
  if (!past.count || !past.last) return {};
  const std::string day = local_time(*past.last, "%Y-%m-%d");
  return "  " + std::to_string(*past.count) + " times, the last " +
         (day == local_time(past.at, "%Y-%m-%d") ? "" : day + " ") + "at " + clock_of(*past.last);
}

}  // namespace

std::vector<std::string> history_screen(const protocol::HistoryResult& history) {
  std::vector<std::string> lines;
  std::string day;
  for (const protocol::PastEvent& past : history.events) {
    const std::string this_day = local_time(past.at, "%Y-%m-%d");
    if (this_day != day) {
      lines.push_back("  " + this_day);
      day = this_day;
    }
    lines.push_back("  " + clock_of(past.at) + "  " + event_words(past.event) +
                    (past.client ? " (" + *past.client + ")" : "") + series_words(past));
  }
  if (lines.empty()) lines.emplace_back("  no events");
  return lines;
}

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/trips_screen.h"

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

std::string line_of(const std::string& when, const std::string& reason, const std::string& coil,
                    const std::string& current, const std::string& playing,
                    const std::string& recording) {
  return "  " + left(when, 21) + left(reason, 17) + " " + right(coil, 7) + right(current, 8) +
         "  " + left(playing, 12) + " " + recording;
}

}  // namespace

std::vector<std::string> trips_screen(const protocol::HistoryResult& history,
                                      const ScreenStyle& style) {
  const auto width = [&](std::size_t columns) { return style.cuts ? columns : std::string::npos; };
  std::vector<std::string> lines;
  for (auto it = history.events.rbegin(); it != history.events.rend(); ++it) {
    if (!protocol::is_trip(it->event)) continue;
    const protocol::Event& event = it->event;
    lines.push_back(line_of(local_time(it->at, "%Y-%m-%d %H:%M:%S"),
                            cut(event.reason.value_or("-"), width(17)),
                            event.temperature_c ? fixed(*event.temperature_c, 1) + " °C" : "-",
                            fixed(*event.current_a, 1) + " A",
                            cut(it->client.value_or(it->method.value_or("-")), width(12)),
                            it->recording.value_or("-")));
  }
  if (!lines.empty()) {
    lines.insert(lines.begin(),
                 line_of("WHEN", "REASON", "COIL", "CURRENT", "PLAYING", "BLACK BOX"));
  }
  if (history.more)
    lines.emplace_back("  older ones are not shown");
  else if (lines.empty())
    lines.emplace_back("  no trips");
  return lines;
}

}  // namespace hedgehog::client

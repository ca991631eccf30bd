// SPDX-License-Identifier: MIT
// `hedgehogctl events`: one line per event; recurring events are summarized once a minute.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "clients/ctl/events/event_series.h"

namespace hedgehog::client {

/// Lines to be printed. Of a series its first event at once, and then, while it continues, their
/// number `kRepeatEvery` after its last line. One thread.
class EventLog {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kRepeatEvery{60};

  /// The line of `event`; none: it was counted in a series. `clock` is the local time of day.
  std::vector<std::string> take(const protocol::Event& event, const std::string& clock,
                                Clock::time_point now);
  /// Lines of the series with unprinted events that are due.
  std::vector<std::string> due(Clock::time_point now);
  /// Lines of all series with unprinted events, at the end.
  std::vector<std::string> rest();

 private:
  struct Entry {
    EventSeries series;
    Clock::time_point printed_at;
    bool is_printed = true;
  };

  /// One per type and, of measurements, per set of them.
  std::vector<Entry> entries_;
};

}  // namespace hedgehog::client

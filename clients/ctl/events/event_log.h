// SPDX-License-Identifier: MIT
// `hedgehogctl events`: one line an event, and recurring events as a line a minute.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "clients/ctl/events/event_series.h"

namespace hedgehog::client {

/// The lines that are to be printed. Of a series its first event at once, and then, while it goes
/// on, how many there were, `kRepeatEvery` after the last line of it. One thread.
class EventLog {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kRepeatEvery{60};

  /// The line of `event`; none: it is counted in a series. `clock` is the person's time of day.
  std::vector<std::string> take(const protocol::Event& event, const std::string& clock,
                                Clock::time_point now);
  /// Of the series with events that were not printed, those that are due.
  std::vector<std::string> due(Clock::time_point now);
  /// All of them, at the end.
  std::vector<std::string> rest();

 private:
  struct Entry {
    EventSeries series;
    Clock::time_point printed_at;
    bool is_printed = true;
  };

  /// One a type.
  std::vector<Entry> entries_;
};

}  // namespace hedgehog::client

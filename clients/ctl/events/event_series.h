// SPDX-License-Identifier: MIT
// Recurring events of one type, as one line.
#pragma once

#include <cstdint>
#include <string>

#include "protocol/values/event.h"

namespace hedgehog::client {

/// An event, and those of its type that followed within the maximum gap; always one for types that
/// do not recur (protocol/values/event.h). One thread.
class EventSeries {
 public:
  /// `clock` is the local time of day, "14:03:21".
  EventSeries(protocol::Event event, std::string clock);

  /// Adds the next event; false: it does not belong to this series.
  bool add(const protocol::Event& next, const std::string& clock);

  /// True for an event of its type and, of measurements, of the same ones.
  bool is_of(const protocol::Event& event) const noexcept {
    return event.type == event_.type && event.disagreement == event_.disagreement;
  }
  /// "  14:05:33  overrun  180 ticks skipped, 37 times since 14:03:21": the time of the last event,
  /// the sum of skipped ticks, the number of events, and the time of the first.
  std::string line() const;

 private:
  protocol::Event event_;
  std::int64_t first_ns_;
  std::int64_t last_ns_;
  std::string first_clock_;
  std::string last_clock_;
  std::int64_t count_ = 1;
};

}  // namespace hedgehog::client

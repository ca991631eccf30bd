// SPDX-License-Identifier: MIT
#include "clients/ctl/events/event_series.h"

#include <utility>

#include "clients/ctl/events/event_words.h"

namespace hedgehog::client {

namespace {

constexpr std::int64_t kMaxGapNs = protocol::kSeriesMaxGapMs * 1'000'000;
constexpr std::int64_t kMaxNs = protocol::kSeriesMaxMs * 1'000'000;

}  // namespace

EventSeries::EventSeries(protocol::Event event, std::string clock)
    : event_(std::move(event)),
      first_ns_(event_.time_ns),
      last_ns_(event_.time_ns),
      first_clock_(std::move(clock)),
      last_clock_(first_clock_) {}

bool EventSeries::add(const protocol::Event& next, const std::string& clock) {
  if (!is_of(next) || !protocol::is_recurring(next.type)) return false;
  if (next.time_ns < last_ns_ || next.time_ns - last_ns_ > kMaxGapNs ||
      next.time_ns - first_ns_ > kMaxNs)
    return false;
  last_ns_ = next.time_ns;
  last_clock_ = clock;
  ++count_;
  if (next.skipped) event_.skipped = event_.skipped.value_or(0) + *next.skipped;
  return true;
}

std::string EventSeries::line() const {
  std::string line = "  " + last_clock_ + "  " + event_words(event_);
  if (count_ > 1) line += ", " + std::to_string(count_) + " times since " + first_clock_;
  return line;
}

}  // namespace hedgehog::client

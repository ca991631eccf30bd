// SPDX-License-Identifier: MIT
// `hedgehogctl watch`: the ball live, in 80x22 or larger.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "clients/common/terminal.h"
#include "clients/ctl/events/recent_events.h"
#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/status_screen.h"
#include "protocol/values/event.h"

namespace hedgehog::client {

/// Keeps the temperatures of the last minute and the newest events. One thread.
class WatchScreen {
 public:
  explicit WatchScreen(ScreenStyle style) : style_(style) {}

  /// The terminal's size, at least 80x22: gauges use the additional columns, events the remaining
  /// rows.
  void set_size(TerminalSize size);

  void take(const protocol::Status& status);
  /// `clock` is the local time of day, "14:03:21".
  void take(const protocol::Event& event, const std::string& clock);

  std::vector<std::string> lines(const Ball& ball) const;

 private:
  std::vector<double> last_minute(std::size_t width) const;
  std::string minute_line(const protocol::Status& status) const;

  ScreenStyle style_;
  std::size_t rows_ = 22;
  std::deque<double> minute_c_;
  std::int64_t next_sample_ns_ = 0;
  RecentEvents events_;
};

}  // namespace hedgehog::client

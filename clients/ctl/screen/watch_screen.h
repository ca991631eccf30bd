// SPDX-License-Identifier: MIT
// `hedgehogctl watch`: the ball as it lives, in 80x24 or wider.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/status_screen.h"
#include "protocol/values/event.h"

namespace hedgehog::client {

/// Remembers the last minute of temperature and the newest events. One thread.
class WatchScreen {
 public:
  explicit WatchScreen(ScreenStyle style) : style_(style) {}

  /// The terminal's, at least 80: the picture takes all of them.
  void set_columns(std::size_t columns) { style_.columns = columns; }

  void take(const protocol::Status& status);
  /// `clock` is the person's time of day, "14:03:21".
  void take(const protocol::Event& event, const std::string& clock);

  std::vector<std::string> lines(const Ball& ball) const;

 private:
  std::vector<double> last_minute(std::size_t width) const;
  std::string minute_line(const protocol::Status& status) const;

  ScreenStyle style_;
  std::deque<double> minute_c_;
  std::int64_t next_sample_ns_ = 0;
  std::deque<std::string> happened_;
};

/// One event in words: "#431 ended: stopped, 9.8 A ..."; for `watch` and `events`.
std::string event_words(const protocol::Event& event);

}  // namespace hedgehog::client

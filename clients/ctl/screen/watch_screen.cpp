// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/watch_screen.h"

#include <algorithm>
#include <utility>

#include "clients/ctl/screen/ball_map.h"
#include "clients/ctl/terminal/bar.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

constexpr std::size_t kUsualColumns = 80;
constexpr std::size_t kBallColumns = 79;
/// Half a kelvin per column; a wider gauge adds no information.
constexpr std::size_t kMaxGaugeColumns = 100;
constexpr std::int64_t kMinuteNs = 60'000'000'000;
constexpr std::size_t kMaxSamples = 240;
constexpr std::int64_t kSampleNs = kMinuteNs / static_cast<std::int64_t>(kMaxSamples);

/// Columns between the numbers on the left and the words on the right of a gauge.
std::size_t free_columns(const ScreenStyle& style) {
  return style.columns - kUsualColumns + kBarColumns;
}

std::string push_words(const protocol::Status& status) {
  return status.pin ? fixed(current_norm_a(status), 1) + " A, " + fixed(status.force_n, 3) +
                          " N at pin " + std::to_string(*status.pin)
                    : "no force";
}

std::string headroom_words_of(const Ball& ball) {
  const protocol::Status& status = ball.status;
  if (!status.temperature_c.model)
    return row("headroom", "unknown", "no current is allowed until the temperature is known");
  if (status.state != "armed") return row("headroom", "none", "no current is allowed");
  std::string behind = status.derating ? "derated now" : "at this current";
  if (status.burst_s) {
    behind +=
        "; " + fixed(ball.hello.limits.current_a, 0) + " A for " + time_words(*status.burst_s);
  }
  return row("headroom", headroom_words(status.headroom_s), behind);
}

std::string loop_words_of(const protocol::Status& status) {
  const protocol::LoopStatus& loop = status.loop;
  return row("loop", grouped(loop.rate_hz) + " /s",
             "late by " + fixed(loop.lateness_us.p99, 0) + " µs at p99, " +
                 (loop.skipped == 0 ? "none" : grouped(static_cast<double>(loop.skipped))) +
                 " skipped;  fan " +
                 (status.fan.speed_rpm ? grouped(*status.fan.speed_rpm) + " /min" : "unknown"));
}

}  // namespace

void WatchScreen::set_size(TerminalSize size) {
  style_.columns = size.columns;
  rows_ = size.rows;
}

void WatchScreen::take(const protocol::Status& status) {
  const std::optional<double>& shown = status.temperature_c.model;
  if (!shown || status.time_ns < next_sample_ns_) return;
  next_sample_ns_ = status.time_ns + kSampleNs;
  minute_c_.push_back(*shown);
  if (minute_c_.size() > kMaxSamples) minute_c_.pop_front();
}

void WatchScreen::take(const protocol::Event& event, const std::string& clock) {
  events_.take(event, clock);
}

std::vector<double> WatchScreen::last_minute(std::size_t width) const {
  const std::size_t points = std::min(width, kMaxSamples);
  std::vector<double> values;
  for (std::size_t i = 0; i < points; ++i) {
    // The newest sample of the column's interval; missing samples are left out.
    const std::size_t ago = kMaxSamples - (i + 1) * kMaxSamples / points;
    if (ago < minute_c_.size()) values.push_back(minute_c_[minute_c_.size() - 1 - ago]);
  }
  return values;
}

std::string WatchScreen::minute_line(const protocol::Status& status) const {
  if (minute_c_.empty()) return row("last minute", "", "");
  const std::size_t width = free_columns(style_);
  const std::vector<double> values = last_minute(width);
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  return row("last minute", hottest_winding(status),
             left(sparkline(values, 4.0, style_.ascii), width) + "  " + fixed(*lowest, 0) + " to " +
                 fixed(*highest, 0) + (style_.ascii ? " C" : " °C"));
}

std::vector<std::string> WatchScreen::lines(const Ball& ball) const {
  const protocol::Status& status = ball.status;
  std::vector<std::string> lines{live_title(status, style_)};
  const std::string margin((style_.columns - kBallColumns) / 2, ' ');
  std::optional<model::Vec3> up;
  if (status.orientation) up = status.orientation->up;
  for (const std::string& line : ball_map(pin_array(ball.description), status.pins.force_n,
                                          {.ascii = style_.ascii, .world_up = up}))
    lines.push_back(margin + line);
  lines.push_back("    " + left(ball_map_legend(style_.ascii), 44) + push_words(status));
  lines.push_back(status.remedy ? "  " + *status.remedy : "");
  const std::optional<double>& sensor = status.temperature_c.sensor;
  const std::string degrees = style_.ascii ? " C" : " °C";
  const auto gauge = static_cast<int>(std::min(free_columns(style_), kMaxGaugeColumns));
  lines.push_back(
      temperature_line(ball, "thermistor " + (sensor ? fixed(*sensor, 1) + degrees : "unknown"),
                       style_.ascii, gauge));
  lines.push_back(minute_line(status));
  lines.push_back(current_line(ball,
                               "x " + fixed_signed(status.current_a.x, 1) + "  y " +
                                   fixed_signed(status.current_a.y, 1) + "  z " +
                                   fixed_signed(status.current_a.z, 1),
                               style_.ascii, gauge));
  lines.push_back(headroom_words_of(ball));
  lines.push_back(loop_words_of(status));
  lines.emplace_back();
  const std::size_t free = rows_ - std::min(rows_, lines.size());
  for (std::string& line : events_.lines(std::max(free, RecentEvents::kMinLines)))
    lines.push_back(std::move(line));
  return lines;
}

}  // namespace hedgehog::client

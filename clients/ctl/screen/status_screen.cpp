// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/status_screen.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "clients/ctl/events/event_words.h"
#include "clients/ctl/terminal/words.h"
#include "model/geometry/direction.h"
#include "model/quaternion.h"

namespace hedgehog::client {

namespace {

using protocol::Status;

std::string title_line(const Ball& ball, const ScreenStyle& style) {
  const Status& status = ball.status;
  const double up_s = static_cast<double>(status.loop.ticks) / 1000.0;
  const std::string behind = "hedgehogd " + ball.hello.version + ", up " + time_words(up_s) + ", " +
                             (status.simulated ? "SIMULATED" : "USB");
  const std::string plain = state_words(status, {});
  const std::size_t gap = columns(plain) + columns(behind) < 76
                              ? 76 - columns(plain) - columns(behind)
                              : std::size_t{2};
  return "  " + state_words(status, style) + std::string(gap, ' ') + behind;
}

std::string force_line(const Status& status) {
  if (!status.pin) return row("force", "0.000 N", "no force");
  return row(
      "force", fixed(status.force_n, 3) + " N",
      "at pin " + std::to_string(*status.pin) + ", " + std::string(model::side_name(status.field)));
}

std::string headroom_line(const Ball& ball) {
  const Status& status = ball.status;
  if (!status.temperature_c.model)
    return row("headroom", "unknown", "no current is allowed until the temperature is known");
  if (status.state != "armed") return row("headroom", "none", "no current is allowed");
  std::string behind = "at this current";
  if (status.burst_s) {
    behind += "; " + fixed(ball.hello.limits.current_a, 0) + " A for " +
              time_words(*status.burst_s) + ", then less";
  }
  return row("headroom", headroom_words(status.headroom_s), behind);
}

std::string coils_line(const Status& status) {
  std::string line = "  coils                ";
  for (int coil = 0; coil < 3; ++coil) {
    const double percent = 100.0 * status.duty[coil];
    line += std::string(1, "xyz"[coil]) + " " + right(fixed_signed(status.current_a[coil], 1), 5) +
            " A " + right(fixed_signed(percent, 0), 3) + " %" + (coil < 2 ? "    " : "");
  }
  return line;
}

std::string fan_line(const Status& status) {
  return row("fan", status.fan.speed_rpm ? grouped(*status.fan.speed_rpm) + " /min" : "unknown",
             fixed(100.0 * status.fan.duty, 0) + " %");
}

std::string orientation_line(const Status& status) {
  if (!status.orientation) return row("orientation", "none", "no sensor");
  const auto& orientation = *status.orientation;
  const model::Vec3 front = rotate(orientation.quaternion, {1, 0, 0});
  const double heading = std::atan2(front.y, front.x) * 180.0 / std::numbers::pi;
  return row("orientation", std::to_string(orientation.age_ms) + " ms old",
             tilt_words(orientation.up.x, orientation.up.y, orientation.up.z, heading));
}

std::string loop_line(const Status& status) {
  const protocol::LoopStatus& loop = status.loop;
  return row("loop", grouped(loop.rate_hz) + " /s",
             "late by " + fixed(loop.lateness_us.p99, 0) + " µs at p99, " +
                 grouped(loop.lateness_us.max) + " µs at most; " +
                 (loop.skipped == 0 ? "none skipped"
                                    : grouped(static_cast<double>(loop.skipped)) + " skipped"));
}

void append_playing(const Status& status, const ScreenStyle& style,
                    std::vector<std::string>& lines) {
  const auto width = [&](std::size_t columns) { return style.cuts ? columns : std::string::npos; };
  if (status.effects.empty()) lines.push_back(row("playing", "nothing", ""));
  for (std::size_t i = 0; i < status.effects.size(); ++i) {
    const protocol::EffectStatus& effect = status.effects[i];
    const std::string left_words =
        effect.playing ? time_words(static_cast<double>(effect.remaining_ms) / 1000.0) + " left"
                       : "waits";
    lines.push_back(row(i == 0 ? "playing" : "", "#" + std::to_string(effect.effect),
                        left(cut(effect_words(effect), width(10)), 10) +
                            right(fixed(effect.current_a, 1) + " A", 7) + "   " +
                            left(left_words, 13) + cut(effect.client.value_or(""), width(24))));
  }
}

std::string last_trip_line(const Status& status) {
  if (!status.last_trip) return row("last trip", "none", "since the start");
  const double ago_s = static_cast<double>(status.time_ns - status.last_trip->time_ns) / 1e9;
  return row(
      "last trip", time_words(ago_s),
      "ago: " + status.last_trip->reason + disagreement_words(status.last_trip->disagreement));
}

/// `words`, and the keys at the right edge; `plain`: the words without colour sequences.
std::string with_keys(const std::string& plain, const std::string& words, std::size_t width) {
  const std::string keys = "SPACE stops   q quits";
  const std::size_t edge = width - 3;
  const std::size_t taken = columns(plain) + columns(keys);
  const std::size_t gap = taken < edge ? edge - taken : std::size_t{2};
  return " " + words + std::string(gap, ' ') + keys;
}

}  // namespace

std::string state_words(const Status& status, const ScreenStyle& style) {
  std::string words = status.state == "tripped" ? "TRIPPED" : status.state;
  if (status.reason) words += ": " + *status.reason;
  if (style.colour) {
    const char* colour = status.state == "tripped"          ? "\033[31m"
                         : status.derating || status.reason ? "\033[33m"
                         : status.state == "armed"          ? "\033[32m"
                                                            : "\033[33m";
    words = colour + words + "\033[0m";
  }
  return status.device + (style.ascii ? " - " : " · ") + words;
}

std::string live_title(const Status& status, const ScreenStyle& style) {
  const std::string allowed =
      std::string(style.ascii ? " - " : " · ") + fixed(allowed_a(status), 1) + " A allowed";
  return with_keys(state_words(status, {.colour = false, .ascii = style.ascii}) + allowed,
                   state_words(status, style) + allowed, style.columns);
}

std::string warning_title(const std::string& warning, const ScreenStyle& style) {
  return with_keys(warning, style.colour ? "\033[31m" + warning + "\033[0m" : warning,
                   style.columns);
}

std::vector<std::string> status_screen(const Ball& ball, const ScreenStyle& style) {
  const Status& status = ball.status;
  std::vector<std::string> lines{title_line(ball, style), ""};
  if (status.remedy) {
    lines.push_back("  " + *status.remedy);
    if (status.state != "armed")
      lines.push_back("  " + time_words(status.since_s) + " ago. The coils are off and stay off.");
    lines.emplace_back();
  }
  lines.push_back(temperature_line(ball, thresholds_words(ball), style.ascii));
  if (std::string windings = windings_line(status, style.ascii); !windings.empty())
    lines.push_back(std::move(windings));
  lines.push_back(thermistor_line(ball, style.ascii));
  if (status.temperature_c.thermometer) {
    lines.push_back(row("thermometer", fixed(*status.temperature_c.thermometer, 1) + " °C",
                        "the second one, beside the board's"));
  }
  lines.push_back(current_line(ball, allowed_words(ball), style.ascii));
  lines.push_back(force_line(status));
  lines.push_back(headroom_line(ball));
  lines.emplace_back();
  lines.push_back(coils_line(status));
  lines.push_back(fan_line(status));
  lines.push_back(orientation_line(status));
  lines.push_back(loop_line(status));
  lines.emplace_back();
  append_playing(status, style, lines);
  lines.push_back(last_trip_line(status));
  return lines;
}

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
#include "clients/ctl/terminal/words.h"

#include <cmath>
#include <cstdint>
#include <ctime>

#include "base/wall_time.h"
#include "model/units.h"

namespace hedgehog::client {

namespace {

std::string two_parts(std::int64_t large, const char* large_unit, std::int64_t small,
                      const char* small_unit) {
  std::string text = std::to_string(large) + " " + large_unit;
  if (small != 0) text += " " + std::to_string(small) + " " + small_unit;
  return text;
}

}  // namespace

std::string row(std::string_view name, std::string_view value, std::string_view behind) {
  const std::string line = "  " + left(name, 11) + right(value, 11);
  return behind.empty() ? line : line + "  " + std::string(behind);
}

std::string time_words(double seconds) {
  if (seconds < 9.95) return fixed(seconds, seconds == std::floor(seconds) ? 0 : 1) + " s";
  const auto s = static_cast<std::int64_t>(std::llround(seconds));
  if (s < 60) return std::to_string(s) + " s";
  if (s < 3600) return two_parts(s / 60, "min", s % 60, "s");
  if (s < 86'400) return two_parts(s / 3600, "h", s % 3600 / 60, "min");
  return two_parts(s / 86'400, "d", s % 86'400 / 3600, "h");
}

std::string headroom_words(std::optional<double> seconds) {
  return seconds ? time_words(*seconds) : "for ever";
}

std::string local_time(const std::string& time, const char* format) {
  const auto unix_ms = base::parse_rfc3339(time);
  const std::time_t seconds = unix_ms ? static_cast<std::time_t>(*unix_ms / 1000) : 0;
  std::tm parts{};
  char text[32];
  if (!unix_ms || ::localtime_r(&seconds, &parts) == nullptr ||
      std::strftime(text, sizeof text, format, &parts) == 0)
    return time;
  return text;
}

std::string tilt_words(double up_x, double up_y, double up_z, double heading_deg) {
  // World-up leaning towards the ball's right means that the ball leans to its left.
  const double to_left = std::atan2(-up_y, up_z) * model::kDegreesPerRadian;
  const double forward = std::atan2(-up_x, std::hypot(up_y, up_z)) * model::kDegreesPerRadian;
  const auto lean = [](double degrees, const char* plus, const char* minus) {
    return fixed(std::abs(degrees), 0) + "° " + (degrees >= 0.0 ? plus : minus);
  };
  if (std::abs(to_left) < 0.5 && std::abs(forward) < 0.5)
    return "level, heading " + fixed(heading_deg, 0) + "°";
  return "tilted " + lean(to_left, "left", "right") + ", " + lean(forward, "forward", "back") +
         ", heading " + fixed(heading_deg, 0) + "°";
}

}  // namespace hedgehog::client

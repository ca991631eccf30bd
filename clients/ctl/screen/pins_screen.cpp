// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/pins_screen.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "clients/ctl/screen/ball_map.h"
#include "clients/ctl/terminal/bar.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

/// Drawn as a dot below this.
constexpr double kStillMm = 0.005;
/// Full scale of the gauges: the extension of the most common pin at 15 A, by the simulation of the
/// thesis.
constexpr double kGaugeMm = 0.5;
constexpr std::size_t kFarthest = 5;

std::size_t common_size(const model::PinMotion& pins) {
  return std::min(pins.force_n.size(), pins.extension_mm.size());
}

/// The numbers of the extended pins, the most extended first.
std::vector<std::size_t> pins_out(const model::PinMotion& pins) {
  std::vector<std::size_t> out(common_size(pins));
  std::iota(out.begin(), out.end(), std::size_t{0});
  std::erase_if(
      out, [&](std::size_t pin) { return pins.extension_mm[pin] < kStillMm; });
  std::stable_sort(out.begin(), out.end(), [&](std::size_t a, std::size_t b) {
    return pins.extension_mm[a] > pins.extension_mm[b];
  });
  return out;
}

std::string count_words(const model::PinMotion& pins) {
  const auto in = std::count_if(pins.extension_mm.begin(), pins.extension_mm.end(),
                                [](double mm) { return mm <= -kStillMm; });
  return std::to_string(pins_out(pins).size()) + " out, " + std::to_string(in) + " in";
}

std::string pin_line(const Ball& ball, std::size_t pin, bool ascii) {
  const model::PinMotion& pins = ball.status.pins;
  const double out_mm = pins.extension_mm[pin];
  std::string rest;
  if (pin < ball.description.pins.size()) {
    const double rest_mm = ball.description.pins[pin].rest_mm;
    rest = rest_mm > 0.0 ? "rests " + fixed(rest_mm, 2) + " mm out" : "rests on the shell";
  }
  return "  pin " + right(std::to_string(pin), 2) + right(fixed(pins.force_n[pin], 3) + " N", 11) +
         right(fixed_signed(out_mm, 3) + " mm", 12) + "  " + bar(out_mm, 0.0, kGaugeMm, {}, ascii) +
         "  " + rest;
}

}  // namespace

std::string aimed_pin_words(const protocol::Status& status) {
  if (!status.pin) return "no force";
  const auto pin = static_cast<std::size_t>(*status.pin);
  const std::string out =
      pin < common_size(status.pins) ? ", " + fixed(status.pins.extension_mm[pin], 2) + " mm" : "";
  return fixed(status.force_n, 3) + " N" + out + " at pin " + std::to_string(pin);
}

std::vector<std::string> pins_screen(const Ball& ball, const ScreenStyle& style) {
  const protocol::Status& status = ball.status;
  std::optional<model::Vec3> up;
  if (status.orientation) up = status.orientation->up;
  std::vector<std::string> lines{live_title(status, style)};
  for (std::string& line :
       ball_numbers(pin_array(ball.description), status.pins.extension_mm, status.pins.force_n,
                    {.ascii = style.ascii, .world_up = up, .colour = style.colour}))
    lines.push_back(std::move(line));
  lines.push_back("    " + left("hundredths of a millimetre out of rest", 46) +
                  count_words(status.pins));
  lines.push_back(status.remedy ? "  " + *status.remedy : "");
  const std::vector<std::size_t> out = pins_out(status.pins);
  for (std::size_t i = 0; i < kFarthest; ++i) {
    lines.push_back(i < out.size() ? pin_line(ball, out[i], style.ascii)
                    : i == 0       ? "  all pins rest"
                                   : "");
  }
  lines.emplace_back();
  lines.push_back(current_line(ball, allowed_words(ball), style.ascii));
  return lines;
}

std::string pins_line(const protocol::Status& status) {
  const std::vector<std::size_t> out = pins_out(status.pins);
  std::string line = right(fixed(static_cast<double>(status.time_ns) / 1e9, 2) + " s", 14) +
                     right(fixed(current_norm_a(status), 1) + " A", 9) + "   ";
  if (out.empty()) return line + "all pins rest";
  const std::size_t pin = out.front();
  return line + fixed(status.pins.force_n[pin], 3) + " N   " +
         fixed_signed(status.pins.extension_mm[pin], 3) + " mm at pin " + std::to_string(pin) +
         "   " + count_words(status.pins);
}

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/ball_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

constexpr int kFront = 39;  // column of the front's meridian
constexpr int kMapColumns = 79;
constexpr std::size_t kMapRows = 8;
/// Pins cannot extend beyond their casing; guards against invalid values.
constexpr double kMaxShownMm = 9.99;
/// Rings get narrower towards the poles, though less than on the ball: marks must not touch.
struct Shape {
  double half_turn;  // columns from front to back at the equator
  double narrowing;  // exponent of a ring's radius
};
constexpr Shape kMarks{30, 0.85};
/// On the ball of the thesis no two pins are closer than four columns, as the tests verify.
constexpr Shape kNumbers{37, 0.5};

/// Each column: a character with its colour sequences.
using Row = std::array<std::string, kMapColumns>;

std::string_view mark_of(double force_n, bool ascii) {
  if (force_n >= kStrongN) return ascii ? "@" : "●";
  if (force_n >= kClearN) return ascii ? "O" : "○";
  if (force_n >= kFeltN) return ascii ? "o" : "∘";
  return ascii ? "." : "·";
}

int column_of(const model::Vec3& pin, const Shape& shape) {
  const double width = std::pow(std::hypot(pin.x, pin.y), shape.narrowing);
  const double turn = std::atan2(pin.y, pin.x) / std::numbers::pi;
  return kFront - static_cast<int>(std::lround(shape.half_turn * width * turn));
}

std::string text_of(const Row& row) {
  std::string line;
  std::string gap;
  for (const std::string& column : row) {
    if (column.empty()) {
      gap += ' ';
    } else {
      line += gap + column;
      gap.clear();
    }
  }
  return line;
}

/// "up" and the rings; `put` draws a pin at its column.
template <class Put>
std::vector<std::string> unrolled(const model::PinArray& pins, const Shape& shape, Put put) {
  std::vector<std::string> lines{std::string(kFront - 1, ' ') + "up"};
  std::array<Row, kMapRows> rows;
  const std::size_t rings = std::max(pins.rings(), kMapRows);
  for (const model::Pin& pin : pins.pins) {
    const std::size_t row = static_cast<std::size_t>(pin.ring) * kMapRows / rings;
    put(rows[row], column_of(pin.position, shape), pin.id);
  }
  for (const Row& row : rows) lines.push_back(text_of(row));
  return lines;
}

double at(std::span<const double> values, int pin) {
  const auto i = static_cast<std::size_t>(pin);
  return i < values.size() ? values[i] : 0.0;
}

int pin_towards(const model::PinArray& pins, const std::optional<model::Vec3>& direction) {
  return direction ? model::nearest_pin(pins, *direction).id : -1;
}

const char* triangle(bool ascii) { return ascii ? "^" : "▲"; }

}  // namespace

std::vector<std::string> ball_map(const model::PinArray& pins, std::span<const double> force_n,
                                  const BallMapStyle& style) {
  const int up_pin = pin_towards(pins, style.world_up);
  std::vector<std::string> lines = unrolled(pins, kMarks, [&](Row& row, int column, int pin) {
    row[static_cast<std::size_t>(column)] =
        pin == up_pin ? triangle(style.ascii) : mark_of(at(force_n, pin), style.ascii);
  });
  std::string& widest = lines[1 + kMapRows / 2];
  widest.replace(0, 7, "   back");
  widest += "      back";
  lines.emplace_back("                      left           front          right");
  return lines;
}

std::vector<std::string> ball_numbers(const model::PinArray& pins,
                                      std::span<const double> extension_mm,
                                      std::span<const double> force_n, const BallMapStyle& style) {
  const int up_pin = pin_towards(pins, style.world_up);
  std::vector<std::string> lines = unrolled(pins, kNumbers, [&](Row& row, int column, int pin) {
    // Four columns per pin: the triangle, and three digits that end right of the meridian.
    const double extension = std::clamp(at(extension_mm, pin), -kMaxShownMm, kMaxShownMm);
    const std::string number = fixed(100.0 * extension, 0);
    const bool rests = number == "0";
    const auto last = static_cast<std::size_t>(rests ? column : column + 1);
    // Beyond the edge, or on another pin: if the ball has more pins than fit.
    if (last + 1 < number.size() || last >= row.size()) return;
    const std::size_t first = last + 1 - number.size();
    const auto taken = [](const std::string& shown) { return !shown.empty(); };
    if (std::any_of(row.begin() + static_cast<std::ptrdiff_t>(first),
                    row.begin() + static_cast<std::ptrdiff_t>(last) + 1, taken))
      return;
    for (std::size_t i = 0; i < number.size(); ++i) row[first + i] = number[i];
    if (rests) row[last] = style.ascii ? "." : "·";
    const double force = at(force_n, pin);
    if (style.colour && (force >= kStrongN || force < kFeltN)) {
      row[first] = (force >= kStrongN ? "\033[1m" : "\033[2m") + row[first];
      row[last] += "\033[0m";
    }
    if (pin == up_pin && first > 0) row[first - 1] = triangle(style.ascii);
  });
  lines.emplace_back(
      "   back             left              front              right             back");
  return lines;
}

std::string ball_map_legend(bool ascii) {
  return ascii ? ". rest   o felt   O clear   @ strong" : "· rest   ∘ felt   ○ clear   ● strong";
}

}  // namespace hedgehog::client

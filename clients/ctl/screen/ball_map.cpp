// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/ball_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "model/pin_array.h"

namespace hedgehog::client {

namespace {

constexpr int kFront = 39;        // column of the front's meridian
constexpr double kHalfTurn = 30;  // columns from front to back where the ball is widest
constexpr int kColumns = 79;

using Row = std::array<std::string_view, kColumns>;

std::string_view mark_of(double force_n, bool ascii) {
  if (force_n >= kStrongN) {
    return ascii ? "@" : "●";
  }
  if (force_n >= kClearN) {
    return ascii ? "O" : "○";
  }
  if (force_n >= kFeltN) {
    return ascii ? "o" : "∘";
  }
  return ascii ? "." : "·";
}

/// A ring gets narrower towards the poles, though less than on the ball: marks must not touch.
int column_of(const model::Vec3& pin) {
  const double width = std::pow(std::hypot(pin.x, pin.y), 0.85);
  const double turn = std::atan2(pin.y, pin.x) / std::numbers::pi;
  return kFront - static_cast<int>(std::lround(kHalfTurn * width * turn));
}

std::string text_of(const Row& row) {
  int end = kColumns;
  while (end > 0 && row[static_cast<std::size_t>(end - 1)] == " ") {
    --end;
  }
  std::string line;
  for (int column = 0; column < end; ++column) {
    line += row[static_cast<std::size_t>(column)];
  }
  return line;
}

}  // namespace

std::vector<std::string> ball_map(std::span<const double> force_n, const BallMapStyle& style) {
  const model::PinArray& array = model::hedgehog_86();
  const int up_pin = style.room_up ? model::nearest_pin(array, *style.room_up).id : -1;

  std::vector<std::string> lines{std::string(kFront - 1, ' ') + "up"};
  const std::size_t widest = array.rings() / 2;
  for (std::size_t r = 0; r < array.rings(); ++r) {
    Row row;
    row.fill(" ");
    for (const model::Pin& pin : array.ring(r)) {
      const auto id = static_cast<std::size_t>(pin.id);
      const double force = id < force_n.size() ? force_n[id] : 0.0;
      row[static_cast<std::size_t>(column_of(pin.position))] =
          pin.id == up_pin ? (style.ascii ? "^" : "▲") : mark_of(force, style.ascii);
    }
    std::string line = text_of(row);
    if (r == widest) {
      line.replace(0, 7, "   back");
      line += "      back";
    }
    lines.push_back(std::move(line));
  }
  lines.emplace_back("                      left           front          right");
  return lines;
}

std::string ball_map_legend(bool ascii) {
  return ascii ? ". rest   o felt   O clear   @ strong" : "· rest   ∘ felt   ○ clear   ● strong";
}

}  // namespace hedgehog::client

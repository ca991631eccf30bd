// SPDX-License-Identifier: MIT
#include "clients/common/text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hedgehog::client {

std::string fixed_signed(double value, int digits) {
  const std::string text = fixed(value, digits);
  return std::signbit(value) || text == fixed(0.0, digits) ? text : "+" + text;
}

std::string temperature_words(std::optional<double> celsius) {
  return celsius ? fixed(*celsius, 1) + " °C" : "temperature unknown";
}

std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::string right(std::string_view text, std::size_t width) {
  const std::size_t taken = columns(text);
  return std::string(taken < width ? width - taken : 0, ' ') + std::string(text);
}

std::string left(std::string_view text, std::size_t width) {
  const std::size_t taken = columns(text);
  return std::string(text) + std::string(taken < width ? width - taken : 0, ' ');
}

std::string cut(std::string_view text, std::size_t width) {
  if (columns(text) <= width) return std::string(text);
  std::string shown;
  std::size_t taken = 0;
  for (const char byte : text) {
    if (begins_character(byte) && ++taken == width) break;
    shown += byte;
  }
  return shown + "…";
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream words(text);
  std::string lines;
  std::string line;
  const auto end_line = [&] {
    lines += std::string(indent, ' ') + line + "\n";
    line.clear();
  };
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + columns(line) + 1 + columns(word) > width) end_line();
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) end_line();
  return lines;
}

}  // namespace hedgehog::client

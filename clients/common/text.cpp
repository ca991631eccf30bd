// SPDX-License-Identifier: MIT
#include "clients/common/text.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace hedgehog::client {

namespace {

bool is_zero(std::string_view number) {
  return number.find_first_of("123456789") == std::string_view::npos;
}

}  // namespace

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text[0] == '-' && is_zero(text) ? text + 1 : text;
}

std::string fixed_signed(double value, int digits) {
  const std::string text = fixed(value, digits);
  return text.front() == '-' || is_zero(text) ? text : "+" + text;
}

std::string grouped(double value, char separator) {
  std::string digits = fixed(value, 0);
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  for (std::size_t at = digits.size(); at > first + 3;) {
    at -= 3;
    digits.insert(at, 1, separator);
  }
  return digits;
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

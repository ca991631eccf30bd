// SPDX-License-Identifier: MIT
#include "base/number_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace hedgehog::base {

std::string fixed(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string grouped(double value, char separator) {
  std::string text = fixed(value, 0);
  const std::size_t first = text.front() == '-' ? 1 : 0;
  for (std::size_t at = text.size(); at > first + 3; text.insert(at, 1, separator)) at -= 3;
  return text;
}

std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

}  // namespace hedgehog::base

// SPDX-License-Identifier: MIT
// Parsing of numbers from the command line or a file.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace hedgehog::design {

/// The whole of `text`, without blanks; nullopt if it is not a number or out of range.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return value;
}

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
// A number as it is typed or stands in a file.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace hedgehog::design {

/// The whole of `text`, without blanks; nothing when it is no number or out of range.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return value;
}

}  // namespace hedgehog::design

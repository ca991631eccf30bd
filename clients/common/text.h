// SPDX-License-Identifier: MIT
// Numbers and texts in columns, formatted for users.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/number_text.h"

namespace hedgehog::client {

using base::fixed;
using base::grouped;
/// "+5.0", "-0.3", "0.0".
std::string fixed_signed(double value, int digits);
/// "61.2 °C"; "temperature unknown" if nullopt.
std::string temperature_words(std::optional<double> celsius);

/// True if `byte` begins a character of UTF-8, false if it continues one.
constexpr bool begins_character(char byte) noexcept {
  return (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u;
}
/// Columns that `text` takes on a terminal (each character used here takes one).
std::size_t columns(std::string_view text);
/// `text` padded with spaces on the left or on the right, to at least `width` columns.
std::string right(std::string_view text, std::size_t width);
std::string left(std::string_view text, std::size_t width);
/// `text` cut to `width` columns, with an ellipsis in the last one if it was longer.
std::string cut(std::string_view text, std::size_t width);
/// `text` wrapped to `width` columns, each line indented by `indent` spaces and ended by a line
/// feed.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace hedgehog::client

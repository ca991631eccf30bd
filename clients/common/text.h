// SPDX-License-Identifier: MIT
// Numbers and texts in columns, as people read them.
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
/// "61.2 °C"; "temperature unknown" when there is none.
std::string temperature_words(std::optional<double> celsius);

/// Whether a character of UTF-8 begins with `byte`, or one that began before goes on.
constexpr bool begins_character(char byte) noexcept {
  return (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u;
}
/// Columns that `text` takes on a terminal (every character of ours takes one).
std::size_t columns(std::string_view text);
/// `text` with spaces before or behind it, to at least `width` columns.
std::string right(std::string_view text, std::size_t width);
std::string left(std::string_view text, std::size_t width);
/// `text` cut to `width` columns, the last one then an ellipsis.
std::string cut(std::string_view text, std::size_t width);
/// `text` in lines of at most `width` columns, each after `indent` blanks and ended by "\n".
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace hedgehog::client

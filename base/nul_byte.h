// SPDX-License-Identifier: MIT
// NUL bytes in JSON. RFC 8259 has none: not between tokens (section 2), and in strings only escaped
// (section 7). nlohmann's lexer takes the first for the end of the text and leaves unread what
// follows, so every reader looks for one before it parses.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace hedgehog::base {

/// Position of the first NUL, bytes from the beginning; nullopt: there is none.
constexpr std::optional<std::size_t> first_nul(std::string_view text) noexcept {
  const std::size_t at = text.find('\0');
  return at == std::string_view::npos ? std::nullopt : std::optional(at);
}

/// What is wrong with such a text, for a message.
inline constexpr std::string_view kHasNul = "has a NUL byte, which JSON never has";

}  // namespace hedgehog::base

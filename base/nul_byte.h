// SPDX-License-Identifier: MIT
// NUL bytes in JSON. RFC 8259 does not allow them between tokens (section 2), and in strings only
// escaped (section 7). nlohmann's lexer treats the first as the end of the text and ignores the
// rest, so every reader checks for one before parsing.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace hedgehog::base {

/// Byte offset of the first NUL; nullopt: none.
constexpr std::optional<std::size_t> first_nul(std::string_view text) noexcept {
  const std::size_t at = text.find('\0');
  return at == std::string_view::npos ? std::nullopt : std::optional(at);
}

/// Message for such a text.
inline constexpr std::string_view kHasNul = "has a NUL byte, which JSON never has";

}  // namespace hedgehog::base

// SPDX-License-Identifier: MIT
#include "clients/lib/import/trailing_commas.h"

#include <algorithm>
#include <cstddef>

namespace hedgehog::client {

namespace {

constexpr std::string_view kSpace = " \t\r\n";

/// The position after the string that begins at `at`, or the end of `text`.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return std::min(at + 1, text.size());
}

}  // namespace

std::string without_trailing_commas(std::string_view text) {
  std::string made(text);
  char before = '[';  // the last character outside of strings and white space
  for (std::size_t at = 0; at < text.size();) {
    const char one = text[at];
    if (one == '"') {
      at = end_of_string(text, at);
      before = one;
      continue;
    }
    if (one == ',') {
      const std::size_t next = text.find_first_not_of(kSpace, at + 1);
      const bool closes =
          next != std::string_view::npos && (text[next] == ']' || text[next] == '}');
      const bool has_item = std::string_view("[{,:").find(before) == std::string_view::npos;
      if (closes && has_item) made[at] = ' ';
    }
    if (kSpace.find(one) == std::string_view::npos) before = one;
    ++at;
  }
  return made;
}

}  // namespace hedgehog::client

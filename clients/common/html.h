// SPDX-License-Identifier: MIT
// Escaping of text in HTML. Pure.
#pragma once

#include <string>
#include <string_view>

namespace hedgehog::client {

/// `text` with &, <, > and quotes escaped: for content and quoted attributes.
inline std::string escape_html(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

}  // namespace hedgehog::client

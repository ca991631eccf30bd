// SPDX-License-Identifier: MIT
#include "clients/study/json_lines.h"

#include <algorithm>
#include <optional>

namespace hedgehog::study {

namespace {

std::optional<std::size_t> place_of(std::string_view text, const std::string& key) {
  const std::string wanted = "\"" + key + "\"";
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.substr(at, 2) == "/*") {
      at = std::min(text.find("*/", at + 2), text.size() - 2) + 1;
    } else if (text[at] == '{' || text[at] == '[') {
      ++depth;
    } else if (text[at] == '}' || text[at] == ']') {
      --depth;
    } else if (text[at] == '"') {
      const std::size_t begin = at;
      for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
      const std::size_t next = text.find_first_not_of(" \t\r\n", std::min(at + 1, text.size()));
      if (depth == 1 && next != std::string_view::npos && text[next] == ':' &&
          text.substr(begin, at + 1 - begin) == wanted)
        return begin;
    }
  }
  return std::nullopt;
}

}  // namespace

int line_of_byte(std::string_view text, std::size_t offset) {
  const auto before = text.substr(0, std::min(offset, text.size()));
  return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

int line_of_key(std::string_view text, const std::string& key) {
  const auto place = place_of(text, key);
  return place ? line_of_byte(text, *place) : 1;
}

}  // namespace hedgehog::study

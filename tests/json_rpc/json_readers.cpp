// SPDX-License-Identifier: MIT
// Outcome of each JSON reader for each document: a line of stdin is a document in hexadecimal, its
// line of stdout has an `r` (read) or an `x` (rejected) for each reader of kReaders.
#include <cstddef>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/keys/json_text.h"
#include "base/parse_json.h"
#include "clients/lib/import/import.h"
#include "protocol/wire/json.h"

namespace {

namespace base = hedgehog::base;
using Reader = bool (*)(std::string_view);

/// Patterns are read with the same reader.
bool wire(std::string_view text) {
  constexpr std::size_t kMaxNesting = 32;
  return bool(hedgehog::protocol::parse_json(text, kMaxNesting));
}

bool saved_file(std::string_view text) { return base::parse_json<nlohmann::json>(text).good(); }

bool written_file(std::string_view text) {
  return base::parse_json<nlohmann::ordered_json>(text, base::JsonComments::kAllowed).good();
}

bool configuration(std::string_view text) {
  return bool(hedgehog::keys::parse_json(text, "document"));
}

/// AHAP or HJIF. No document is either, but that error is reported only after parsing.
bool imported_file(std::string_view text) {
  const auto imported = hedgehog::client::import_pattern(text);
  return !imported && imported.error().message.find("neither AHAP") != std::string::npos;
}

constexpr Reader kReaders[] = {wire, saved_file, written_file, configuration, imported_file};

int digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

std::string from_hexadecimal(const std::string& line) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < line.size(); i += 2)
    bytes += static_cast<char>(digit(line[i]) << 4 | digit(line[i + 1]));
  return bytes;
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    const std::string document = from_hexadecimal(line);
    for (const Reader reads : kReaders) std::cout << (reads(document) ? 'r' : 'x');
    std::cout << '\n';
  }
}

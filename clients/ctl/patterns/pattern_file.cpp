// SPDX-License-Identifier: MIT
#include "clients/ctl/patterns/pattern_file.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/regular_file.h"
#include "clients/lib/import/import.h"

namespace hedgehog::client {

bool is_pattern_file(const std::string& text) {
  return text.ends_with(".json") && names_a_file(text);
}

bool names_a_file(const std::string& text) {
  std::error_code ec;
  return protocol::owner_of(text) != protocol::PatternOwner::kVendor ||
         std::filesystem::exists(text, ec);
}

Outcome<std::string> read_text(const std::string& path) {
  base::FileText file = base::read_regular_file(path, kMaxImportBytes);
  if (!file.good()) return ClientError{Failure::kNoInput, path + ": " + file.problem, {}};
  return std::move(file.text);
}

Outcome<protocol::Pattern> read_pattern(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  auto pattern = protocol::decode_pattern(*text);
  if (!pattern) return ClientError{Failure::kBadData, path + ": " + pattern.error().message, {}};
  return *std::move(pattern);
}

std::string pattern_text(const protocol::Pattern& pattern) {
  const auto document = nlohmann::ordered_json::parse(protocol::encode_pattern(pattern));
  std::string out = "{\n";
  for (const auto& [key, value] : document.items())
    if (key != "keyframes") out += "  \"" + key + "\": " + value.dump() + ",\n";
  out += "  \"keyframes\": [";
  const char* before = "\n    ";
  for (const auto& frame : document["keyframes"]) {
    out += before + frame.dump();
    before = ",\n    ";
  }
  return out + "\n  ]\n}";
}

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
#include "clients/ctl/patterns/pattern_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/regular_file.h"

namespace hedgehog::client {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// True if it has the extension of another format.
bool is_foreign(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), lower);
  return ending == ".ahap" || ending == ".hjif";
}

/// The second part of a pattern's name, from the name of a file.
std::string part_of(const std::string& path) {
  std::string part = std::filesystem::path(path).stem().string();
  std::transform(part.begin(), part.end(), part.begin(), [](char c) {
    const char low = lower(c);
    const bool good = (low >= 'a' && low <= 'z') || (low >= '0' && low <= '9');
    return good ? low : '-';
  });
  part.erase(0, part.find_first_not_of('-'));
  constexpr std::size_t kMaxName = 32;
  return part.empty() ? "pattern" : part.substr(0, kMaxName);
}

}  // namespace

bool is_pattern_file(const std::string& text) {
  return (text.ends_with(".json") || is_foreign(text)) && names_a_file(text);
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

Outcome<Imported> read_foreign_pattern(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  auto imported = import_pattern(*text);
  if (!imported) {
    ClientError error = imported.error();
    error.message = path + ": " + error.message;
    return error;
  }
  imported->pattern.name = "imported/" + part_of(path);
  return imported;
}

Outcome<Imported> read_any_pattern(const std::string& path) {
  if (is_foreign(path)) return read_foreign_pattern(path);
  auto pattern = read_pattern(path);
  if (!pattern) return pattern.error();
  return Imported{*std::move(pattern), {}};
}

void print_notes(const std::string& path, const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    std::fprintf(stderr, "hedgehogctl: %s: %s\n", path.c_str(), note.c_str());
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

// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/pattern_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "clients/lib/import/import.h"

namespace hedgehog::client {

bool is_pattern_file(const std::string& text) {
  if (!text.ends_with(".json")) return false;
  std::error_code ec;
  return protocol::owner_of(text) != protocol::PatternOwner::kVendor ||
         std::filesystem::exists(text, ec);
}

Outcome<std::string> read_text(const std::string& path) {
  std::error_code ec;
  if (std::filesystem::is_directory(path, ec))
    return ClientError{Failure::kNoInput, path + ": is a folder", {}};
  std::ifstream file(path, std::ios::binary);
  if (!file) return ClientError{Failure::kNoInput, path + ": " + std::strerror(errno), {}};
  std::string text;
  text.resize(kMaxImportBytes + 1);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (file.bad() || text.size() > kMaxImportBytes)
    return ClientError{Failure::kNoInput, path + ": cannot be read, or is larger than 4 MiB", {}};
  return text;
}

Outcome<protocol::Pattern> read_pattern(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  auto pattern = protocol::decode_pattern(*text);
  if (!pattern) return ClientError{Failure::kBadData, path + ": " + pattern.error().message, {}};
  return *std::move(pattern);
}

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// The files of web pages, all of them in memory: what was not in the folder at the start cannot be
// asked for, by whatever path.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

namespace hedgehog::base {

struct WebFile {
  std::string_view type;
  std::shared_ptr<const std::string> bytes;
};

struct WebFiles {
  /// "/index.html" and so on.
  std::map<std::string, WebFile> by_path{};
  /// Of the folder; what was read before it is there.
  std::error_code error{};
  /// More than `max_bytes`; there are no files then.
  bool too_large = false;

  /// "/" is "/index.html". nullptr: there is no such file.
  const WebFile* find(const std::string& path) const;
};

enum class WebFolder { kAlone, kWithSubfolders };

/// Reads `folder`: regular files of types that browsers know only, no links.
WebFiles read_web_files(const std::string& folder, WebFolder depth, std::size_t max_bytes);

}  // namespace hedgehog::base

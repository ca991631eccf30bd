// SPDX-License-Identifier: MIT
// Files of web pages, all in memory: only files in the folder at start-up can be requested, by any
// path.
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
  /// The same, gzip-compressed, from the file of the same name with `.gz` appended; nullptr:
  /// missing, or its content differs.
  std::shared_ptr<const std::string> gzip{};
  /// Entity tag of this version, including quotes.
  std::string etag{};
  /// True if the name contains a hash of the content, "chunk-3F2A9C01.js": it never changes.
  bool immutable = false;
};

/// Response to a request of a file (RFC 9110, 9111).
struct WebFileResponse {
  /// nullptr: the browser has this version already (304).
  std::shared_ptr<const std::string> body{};
  /// "gzip", or empty.
  std::string_view encoding{};
  std::string etag{};
  /// Cached for a year if immutable; else revalidated each time by its tag.
  std::string_view cache_control{};
  /// "Accept-Encoding" if the body depends on it; or empty.
  std::string_view vary{};
};

/// `accept_encoding`, `if_none_match`: headers of the request, empty if absent.
WebFileResponse web_file_response(const WebFile& file, std::string_view accept_encoding,
                                  std::string_view if_none_match);

struct WebFiles {
  /// "/index.html" and so on.
  std::map<std::string, WebFile> by_path{};
  /// Error of reading the folder; files read before it are kept.
  std::error_code error{};
  /// True if larger than `max_bytes`; then there are no files.
  bool too_large = false;

  /// "/" is "/index.html". nullptr: no such file.
  const WebFile* find(const std::string& path) const;
};

enum class WebFolder { kAlone, kWithSubfolders };

/// Reads `folder`: regular files of known web types and their gzip-compressed versions; no links.
WebFiles read_web_files(const std::string& folder, WebFolder depth, std::size_t max_bytes);

}  // namespace hedgehog::base

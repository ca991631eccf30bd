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
  /// The same by gzip, from the file beside it that has `.gz` behind its name; nullptr: there is
  /// none, or of other content.
  std::shared_ptr<const std::string> gzip{};
  /// Tells versions of one file from each other, with its quotes.
  std::string etag{};
  /// The name has a hash of the content in it, "chunk-3F2A9C01.js": it never changes.
  bool immutable = false;
};

/// What a browser is sent of a file (RFC 9110, 9111).
struct WebFileAnswer {
  /// nullptr: it has this version already (304).
  std::shared_ptr<const std::string> body{};
  /// "gzip", or empty.
  std::string_view encoding{};
  std::string etag{};
  /// Kept for a year when it never changes; else asked for again each time, by its tag.
  std::string_view cache_control{};
  /// "Accept-Encoding" when others would be sent other bytes; or empty.
  std::string_view vary{};
};

/// `accept_encoding`, `if_none_match`: headers of the request, empty where there is none.
WebFileAnswer web_file_answer(const WebFile& file, std::string_view accept_encoding,
                              std::string_view if_none_match);

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

/// Reads `folder`: regular files of types that browsers know only, and those packed by gzip beside
/// them; no links.
WebFiles read_web_files(const std::string& folder, WebFolder depth, std::size_t max_bytes);

}  // namespace hedgehog::base

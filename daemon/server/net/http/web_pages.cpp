// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/web_pages.h"

#include <array>
#include <cstdint>
#include <cstdio>

#include "daemon/device/board_core/crc32.h"

namespace hedgehog::server {
namespace {

/// Tells versions of one file from each other, nothing more.
std::string etag_of(const std::string& bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "\"%08x-%zx\"", board::crc32(data, bytes.size()),
                bytes.size());
  return text.data();
}

}  // namespace

WebPages::WebPages(const std::string& folder) {
  const base::WebFiles files =
      base::read_web_files(folder, base::WebFolder::kWithSubfolders, kMaxBytes);
  if (files.too_large) {
    problem_ = folder + ": more than 32 MB are no pages of ours; none are served";
  } else if (files.error) {
    problem_ = folder + ": " + files.error.message() + "; the dashboard is not served";
  } else {
    for (const auto& [path, file] : files.by_path)
      pages_.emplace(path, WebPage{file, etag_of(*file.bytes)});
    if (!pages_.contains("/index.html"))
      problem_ = folder + ": no index.html there; the dashboard is not served";
  }
}

const WebPage* WebPages::find(const std::string& path) const {
  const auto page = pages_.find(path == "/" ? "/index.html" : path);
  return page == pages_.end() ? nullptr : &page->second;
}

}  // namespace hedgehog::server

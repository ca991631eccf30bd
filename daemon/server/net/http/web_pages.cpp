// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/web_pages.h"

#include <fmt/format.h>

#include <array>
#include <span>

#include "base/crc32.h"

namespace hedgehog::server {
namespace {

/// Tells versions of one file from each other, nothing more.
std::string etag_of(const std::string& bytes) {
  return fmt::format(R"("{:08x}-{:x}")", base::crc32(std::as_bytes(std::span(bytes))),
                     bytes.size());
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

// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/web_pages.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/crc32.h"

namespace hedgehog::server {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kTypes{{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".txt", "text/plain; charset=utf-8"},
    {".webmanifest", "application/manifest+json"},
}};

std::string_view type_of(const fs::path& file) {
  for (const auto& [ending, type] : kTypes)
    if (file.extension() == ending) return type;
  return {};
}

/// Tells versions of one file from each other, nothing more.
std::string etag_of(const std::string& bytes) {
  return fmt::format(R"("{:08x}-{:x}")", base::crc32(std::as_bytes(std::span(bytes))),
                     bytes.size());
}

}  // namespace

WebPages::WebPages(const std::string& folder) {
  std::size_t total = 0;
  std::error_code ec;
  for (fs::recursive_directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    const std::string_view type = type_of(it->path());
    if (type.empty() || it->is_symlink() || !it->is_regular_file()) continue;
    std::ifstream file(it->path(), std::ios::binary);
    auto bytes = std::make_shared<const std::string>(std::istreambuf_iterator<char>(file),
                                                     std::istreambuf_iterator<char>());
    total += bytes->size();
    if (total > kMaxBytes) {
      pages_.clear();
      problem_ = folder + ": more than 32 MB are no pages of ours; none are served";
      return;
    }
    std::string name = "/" + it->path().lexically_relative(folder).generic_string();
    std::string etag = etag_of(*bytes);
    pages_.emplace(std::move(name), WebPage{std::string(type), std::move(etag), std::move(bytes)});
  }
  if (ec) {
    pages_.clear();
    problem_ = folder + ": " + ec.message() + "; the dashboard is not served";
  } else if (!pages_.contains("/index.html")) {
    problem_ = folder + ": no index.html there; the dashboard is not served";
  }
}

const WebPage* WebPages::find(const std::string& path) const {
  const auto page = pages_.find(path == "/" ? "/index.html" : path);
  return page == pages_.end() ? nullptr : &page->second;
}

}  // namespace hedgehog::server

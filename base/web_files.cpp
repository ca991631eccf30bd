// SPDX-License-Identifier: MIT
#include "base/web_files.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace hedgehog::base {
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

}  // namespace

const WebFile* WebFiles::find(const std::string& path) const {
  const auto file = by_path.find(path == "/" ? "/index.html" : path);
  return file == by_path.end() ? nullptr : &file->second;
}

WebFiles read_web_files(const std::string& folder, WebFolder depth, std::size_t max_bytes) {
  WebFiles files;
  std::size_t total = 0;
  for (fs::recursive_directory_iterator it(folder, files.error), end; !files.error && it != end;
       it.increment(files.error)) {
    if (depth == WebFolder::kAlone) it.disable_recursion_pending();
    const std::string_view type = type_of(it->path());
    if (type.empty() || it->is_symlink() || !it->is_regular_file()) continue;
    std::ifstream file(it->path(), std::ios::binary);
    auto bytes = std::make_shared<const std::string>(std::istreambuf_iterator<char>(file),
                                                     std::istreambuf_iterator<char>());
    total += bytes->size();
    if (total > max_bytes) {
      files.by_path.clear();
      files.too_large = true;
      return files;
    }
    std::string path = "/" + it->path().lexically_relative(folder).generic_string();
    files.by_path.emplace(std::move(path), WebFile{type, std::move(bytes)});
  }
  return files;
}

}  // namespace hedgehog::base

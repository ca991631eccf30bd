// SPDX-License-Identifier: MIT
#include "clients/racer/server/pages.h"
#include "clients/common/html.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

namespace hedgehog::racer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = 16u << 20;

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kTypes{{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".txt", "text/plain; charset=utf-8"},
}};

std::string_view type_of(const fs::path& file) {
  for (const auto& [ending, type] : kTypes)
    if (file.extension() == ending) return type;
  return {};
}

PageFile nothing_here(const std::string& folder) {
  return {"text/html; charset=utf-8",
          "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Hedgehog racer</title>"
          "<p>The game runs, but its page was not built: there is no index.html in " +
              client::escape_html(folder) +
              ". <code>make race</code> in the sources builds it (it takes node and npm).</p>\n"};
}

}  // namespace

Pages::Pages(const std::string& folder) {
  std::size_t total = 0;
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    const std::string_view type = type_of(it->path());
    if (type.empty() || it->is_symlink() || !it->is_regular_file()) continue;
    std::ifstream file(it->path(), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    total += bytes.size();
    if (total > kMaxBytes) break;
    files_.insert_or_assign("/" + it->path().filename().string(),
                            PageFile{std::string(type), std::move(bytes)});
  }
  if (total > kMaxBytes || !files_.contains("/index.html")) {
    files_.clear();
    files_.emplace("/index.html", nothing_here(folder));
  }
}

const PageFile* Pages::find(const std::string& path) const {
  const auto file = files_.find(path == "/" ? "/index.html" : path);
  return file == files_.end() ? nullptr : &file->second;
}

std::string Pages::default_folder() {
  std::error_code ec;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec);
  const fs::path installed = program.parent_path().parent_path();
  for (const fs::path& prefix : {installed, installed.parent_path()}) {
    fs::path folder = prefix / "share/hedgehog/racer";
    if (fs::exists(folder, ec)) return folder.string();
  }
  return (installed / "share/hedgehog/racer").string();
}

}  // namespace hedgehog::racer

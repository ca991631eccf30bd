// SPDX-License-Identifier: MIT
#include "clients/racer/server/pages.h"

#include <filesystem>
#include <memory>
#include <system_error>

#include "clients/common/html.h"

namespace hedgehog::racer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = 16u << 20;

std::string missing_page(const std::string& folder) {
  return "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Hedgehog racer</title>"
         "<p>The game runs, but its page was not built: there is no index.html in " +
         client::escape_html(folder) +
         ". <code>make race</code> in the sources builds it (it takes node and npm).</p>\n";
}

}  // namespace

base::WebFiles read_pages(const std::string& folder) {
  base::WebFiles files = base::read_web_files(folder, base::WebFolder::kAlone, kMaxBytes);
  if (files.find("/") == nullptr) {
    files.by_path = {
        {"/index.html",
         {"text/html; charset=utf-8", std::make_shared<const std::string>(missing_page(folder))}}};
  }
  return files;
}

std::string default_pages_folder() {
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

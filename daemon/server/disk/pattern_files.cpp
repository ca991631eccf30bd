// SPDX-License-Identifier: MIT
#include "daemon/server/disk/pattern_files.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/atomic_file.h"
#include "base/regular_file.h"

namespace hedgehog::server {
namespace {

namespace fs = std::filesystem;

/// The readable entries of `folder`; errors are logged. Empty if it does not exist.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code ec;
  for (auto at = fs::directory_iterator(folder, ec); !ec && at != fs::directory_iterator();
       at.increment(ec))
    entries.push_back(at->path());
  if (ec && ec != std::errc::no_such_file_or_directory)
    spdlog::warn("{}: {}; the stored patterns were not loaded", folder.string(), ec.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Temporary file of an aborted write.
bool is_leftover(const fs::path& file) {
  return file.extension() == ".new" && file.stem().extension() == ".json";
}

std::string made_folder(const fs::path& folder) {
  std::error_code ec;
  if (!fs::create_directory(folder, ec))
    return ec ? folder.string() + ": " + ec.message() : std::string();
  return base::sync_folder(folder.parent_path());
}

std::string write(const fs::path& path, const std::string& json) {
  const fs::path vendor = path.parent_path();
  for (const fs::path& folder : {vendor.parent_path(), vendor})
    if (std::string problem = made_folder(folder); !problem.empty()) return problem;
  return base::write_file_atomically(path, json);
}

std::string remove(const fs::path& path) {
  std::error_code ec;
  fs::remove(path, ec);
  if (ec) return path.string() + ": " + ec.message();
  const fs::path vendor = path.parent_path();
  std::error_code not_empty;
  fs::remove(vendor, not_empty);
  for (const fs::path& folder : {vendor, vendor.parent_path()})
    if (fs::exists(folder, ec)) return base::sync_folder(folder);
  return {};
}

}  // namespace

PatternFiles::PatternFiles(const std::string& state_directory, DiskThread& disk)
    : directory_((fs::path(state_directory) / "patterns").string()), disk_(disk) {}

std::string PatternFiles::path_of(const std::string& name) const {
  return (fs::path(directory_) / (name + ".json")).string();
}

std::vector<protocol::Pattern> PatternFiles::load() const {
  std::vector<protocol::Pattern> kept;
  for (const fs::path& vendor : entries_of(directory_)) {
    for (const fs::path& file : entries_of(vendor)) {
      if (is_leftover(file)) {
        std::error_code stays;
        fs::remove(file, stays);
      } else if (file.extension() == ".json" && kept.size() < PatternLibrary::kMaxPut) {
        load(file, kept);
      } else if (file.extension() == ".json") {
        spdlog::warn("{}: not loaded, the limit of {} patterns is reached", file.string(),
                     kept.size());
      }
    }
  }
  return kept;
}

void PatternFiles::load(const std::string& path, std::vector<protocol::Pattern>& kept) const {
  const base::FileText file = base::read_regular_file(path, protocol::kMaxPatternBytes);
  if (!file.good()) {
    spdlog::warn("{}: {}; the pattern was not loaded", path, file.problem);
    return;
  }
  auto pattern = protocol::decode_pattern(file.text);
  if (pattern && path_of(pattern->name) == path) {
    kept.push_back(std::move(*pattern));
  } else {
    spdlog::warn("{}: not a pattern: {}", path,
                 pattern ? "it has another name" : pattern.error().message);
  }
}

DiskWorkPtr PatternFiles::post(std::function<std::string()> job) {
  auto work = std::make_shared<DiskWork>();
  const bool taken = disk_.post(DiskUse::kPattern, [work, job = std::move(job)] {
    work->problem = job();
    if (!work->problem.empty())
      spdlog::error("{}: the stored patterns on disk are out of date", work->problem);
    work->done.store(true, std::memory_order_release);
  });
  return taken ? work : nullptr;
}

DiskWorkPtr PatternFiles::keep(const std::string& name, std::string json) {
  return post([path = path_of(name), json = std::move(json)] { return write(path, json); });
}

DiskWorkPtr PatternFiles::drop(const std::string& name) {
  return post([path = path_of(name)] { return remove(path); });
}

}  // namespace hedgehog::server

// SPDX-License-Identifier: MIT
#include "daemon/server/trip_recordings.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace hedgehog::server {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "trip-";
constexpr std::string_view kSuffix = ".hhr";

struct Recording {
  unsigned number = 0;
  fs::path path;
  std::uintmax_t bytes = 0;
};

std::vector<Recording> recordings(const std::string& directory) {
  std::vector<Recording> found;
  std::error_code ec;
  for (const auto& entry : fs::directory_iterator(directory, ec)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) {
      continue;
    }
    Recording r;
    r.path = entry.path();
    const char* first = name.data() + kPrefix.size();
    const char* last = name.data() + name.size() - kSuffix.size();
    const auto parsed = std::from_chars(first, last, r.number);
    r.bytes = entry.file_size(ec);
    if (parsed.ec == std::errc{} && parsed.ptr == last && !ec) {
      found.push_back(std::move(r));
    }
  }
  std::sort(found.begin(), found.end(), [](auto& a, auto& b) { return a.number < b.number; });
  return found;
}

void record(const std::string& directory, control::FlightRecorder& recorder) {
  // The recorder freezes in the tick of the trip, so it has done so, or the trip was over before.
  if (!recorder.frozen()) {
    return;
  }
  const std::vector<std::byte> bytes = recorder.take();
  const std::string path = next_recording(directory);
  const std::string problem =
      write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  recorder.resume();
  if (problem.empty()) {
    spdlog::info("the last seconds before the trip are in {}", path);
  } else {
    spdlog::error("{}: the trip is not recorded", problem);
  }
  prune_recordings(directory, TripRecordings::kMaxFiles, TripRecordings::kMaxBytes);
}

}  // namespace

std::string next_recording(const std::string& directory) {
  const std::vector<Recording> found = recordings(directory);
  char name[32];
  std::snprintf(name, sizeof name, "trip-%04u.hhr", found.empty() ? 1u : found.back().number + 1);
  return (fs::path(directory) / name).string();
}

void prune_recordings(const std::string& directory, std::size_t max_files,
                      std::uintmax_t max_bytes) {
  std::size_t files = 0;
  std::uintmax_t bytes = 0;
  std::vector<Recording> found = recordings(directory);
  std::reverse(found.begin(), found.end());
  for (const Recording& r : found) {
    ++files;
    bytes += r.bytes;
    if (files > 1 && (files > max_files || bytes > max_bytes)) {
      std::error_code ignored;
      fs::remove(r.path, ignored);
    }
  }
}

void TripRecordings::tripped() {
  disk_.post([directory = directory_, &recorder = recorder_] { record(directory, recorder); });
}

}  // namespace hedgehog::server

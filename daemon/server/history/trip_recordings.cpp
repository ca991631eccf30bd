// SPDX-License-Identifier: MIT
#include "daemon/server/history/trip_recordings.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/regular_file.h"

namespace hedgehog::server {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "trip-";
constexpr const char* kSuffix = ".hhr";
/// Maximum number, so that it can still be incremented.
constexpr unsigned kHighest = 999'999'999;

struct Recording {
  unsigned number = 0;
  fs::path path;
  std::uintmax_t bytes = 0;
};

std::vector<Recording> recordings(const std::string& directory) {
  std::vector<Recording> found;
  std::error_code ec;
  for (const auto& entry : fs::directory_iterator(directory, ec)) {
    const fs::path& path = entry.path();
    const Recording r{recording_number(path.stem().string()), path, entry.file_size(ec)};
    if (path.extension() == kSuffix && r.number != 0 && !ec) found.push_back(r);
  }
  std::sort(found.begin(), found.end(), [](auto& a, auto& b) { return a.number < b.number; });
  return found;
}

std::set<unsigned> numbers_in(const std::string& directory) {
  std::set<unsigned> numbers;
  for (const Recording& recording : recordings(directory)) numbers.insert(recording.number);
  return numbers;
}

void record(const std::string& directory, unsigned number, control::FlightRecorder& recorder) {
  // The recorder freezes in the tick of the trip, so it has frozen, or the recording was already
  // taken.
  if (!recorder.frozen()) return;
  const std::vector<std::byte> bytes = recorder.take();
  const std::string path = recording_path(directory, number);
  const std::string problem = base::write_file_atomically(
      path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  recorder.resume();
  if (problem.empty())
    spdlog::info("the last seconds before the trip are in {}", path);
  else
    spdlog::error("{}: the trip is not recorded", problem);
  prune_recordings(directory, TripRecordings::kMaxFiles, TripRecordings::kMaxBytes);
}

}  // namespace

std::string recording_name(unsigned number) { return fmt::format("trip-{:04}", number); }

unsigned recording_number(std::string_view name) {
  unsigned number = 0;
  if (!name.starts_with(kPrefix)) return 0;
  const char* end = name.data() + name.size();
  const auto parsed = std::from_chars(name.data() + kPrefix.size(), end, number);
  return parsed.ec == std::errc{} && parsed.ptr == end && number <= kHighest ? number : 0;
}

unsigned recording_number_of_file(std::string_view file) {
  const std::string_view suffix = kSuffix;
  const bool is_recording = file.ends_with(suffix);
  return is_recording ? recording_number(file.substr(0, file.size() - suffix.size())) : 0;
}

std::string recording_path(const std::string& directory, unsigned number) {
  return (fs::path(directory) / (recording_name(number) + kSuffix)).string();
}

unsigned last_recording(const std::string& directory) {
  const std::vector<Recording> found = recordings(directory);
  return found.empty() ? 0 : found.back().number;
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

void RecordingNumbers::set(std::set<unsigned> numbers) {
  const std::lock_guard lock(mutex_);
  numbers_ = std::move(numbers);
}

bool RecordingNumbers::contains(unsigned number) const {
  const std::lock_guard lock(mutex_);
  return numbers_.contains(number);
}

TripRecordings::TripRecordings(std::string directory, DiskThread& disk,
                               control::FlightRecorder& recorder, unsigned last_named)
    : directory_(std::move(directory)),
      disk_(disk),
      recorder_(recorder),
      last_(std::max(last_recording(directory_), last_named)),
      written_(std::make_shared<RecordingNumbers>()) {
  written_->set(numbers_in(directory_));
}

unsigned TripRecordings::tripped() {
  ++last_;
  // The pending job takes the frozen recording, that of the first trip.
  if (!queued_->exchange(true)) {
    const bool taken =
        disk_.post(DiskUse::kSafety, [directory = directory_, number = last_, &recorder = recorder_,
                                      written = written_, queued = queued_] {
          queued->store(false);
          record(directory, number, recorder);
          written->set(numbers_in(directory));
        });
    if (!taken) {
      queued_->store(false);
      spdlog::error("the disk is too slow: the trip is not recorded");
    }
  }
  return last_;
}

std::shared_ptr<const RecordingRead> TripRecordings::read(unsigned number) const {
  auto reading = std::make_shared<RecordingRead>();
  const bool taken =
      disk_.post(DiskUse::kDownload, [path = recording_path(directory_, number), reading] {
        reading->bytes = base::read_regular_file(path, kMaxFileBytes).text;
        reading->done.store(true, std::memory_order_release);
      });
  return taken ? reading : nullptr;
}

bool TripRecordings::has(unsigned number) const { return written_->contains(number); }

}  // namespace hedgehog::server

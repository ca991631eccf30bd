// SPDX-License-Identifier: MIT
#include "daemon/server/history/history_files.h"

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/atomic_file.h"
#include "base/regular_file.h"

namespace hedgehog::server {
namespace {

namespace fs = std::filesystem;

/// By HistoryPart.
constexpr std::array<const char*, kHistoryParts> kFiles{
    "effects.jsonl", "trips.jsonl", "events.jsonl", "derating.jsonl", "recurring.jsonl"};
/// Exceeds the size of the maximum number of lines by far.
constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

std::string full_path(const std::string& path) { return path + ".1"; }

std::string content_of(const std::string& path) {
  base::FileText file = base::read_regular_file(path, kMaxBytes);
  if (!file.good() && !file.missing)
    spdlog::error("{}: {}; its events are missing from the history", path, file.problem);
  return std::move(file.text);
}

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(fd, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    text.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  return true;
}

/// Appended text must not continue a truncated line.
bool ends_a_line(int fd, off_t size) {
  char last = 0;
  return size == 0 || (::pread(fd, &last, 1, size - 1) == 1 && last == '\n');
}

/// Appends all of `lines`, or nothing. Empty on success, or the problem.
std::string append(const std::string& path, std::string_view lines, bool begin_file) {
  std::error_code missing;
  // An empty file is the result of a failed creation.
  if (begin_file && fs::file_size(path, missing) > 0 && !missing) {
    std::error_code failed;
    fs::rename(path, full_path(path), failed);
    if (failed) return path + ": " + failed.message();
  }
  const bool fresh = begin_file || !fs::exists(path, missing);
  const int fd =
      ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, 0640);
  if (fd < 0) return path + ": " + std::strerror(errno);
  if (std::string other = base::file_problem(fd); !other.empty()) {
    ::close(fd);
    return path + ": " + other;
  }
  const off_t before = ::lseek(fd, 0, SEEK_END);
  const bool good = before >= 0 && (ends_a_line(fd, before) || write_all(fd, "\n")) &&
                    write_all(fd, lines) && ::fdatasync(fd) == 0;
  std::string problem = good ? std::string() : path + ": " + std::strerror(errno);
  if (!good && before >= 0 && ::ftruncate(fd, before) != 0)
    problem += ", and an incomplete line remains";
  ::close(fd);
  // The lines are written; if the folder entry may be lost at a power failure, repeating does not
  // help.
  if (const std::string unsure =
          good && fresh ? base::sync_folder(fs::path(path).parent_path()) : "";
      !unsure.empty())
    spdlog::warn("{}: {} may be lost in a power failure", unsure, path);
  return problem;
}

}  // namespace

HistoryTexts load_history(const std::string& directory) {
  HistoryTexts texts;
  for (std::size_t i = 0; i < kHistoryParts; ++i) {
    const std::string path = (fs::path(directory) / kFiles[i]).string();
    texts[i] = {content_of(full_path(path)), content_of(path)};
  }
  return texts;
}

EventHistory::Writer history_writer(const std::string& directory, DiskThread& disk) {
  const auto failing = std::make_shared<bool>(false);  // disk thread only
  return [directory, &disk, failing](HistoryPart part, std::string lines, bool begin_file) {
    const std::string path =
        (fs::path(directory) / kFiles[static_cast<std::size_t>(part)]).string();
    auto work = std::make_shared<DiskWork>();
    const bool taken =
        disk.post(DiskUse::kHistory, [path, begin_file, failing, work, lines = std::move(lines)] {
          work->problem = append(path, lines, begin_file);
          const bool failed = !work->problem.empty();
          if (failed && !*failing)
            spdlog::error("{}: events are lost at a restart until writing succeeds", work->problem);
          *failing = failed;
          work->done.store(true, std::memory_order_release);
        });
    return taken ? work : nullptr;
  };
}

}  // namespace hedgehog::server

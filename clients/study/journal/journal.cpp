// SPDX-License-Identifier: MIT
#include "clients/study/journal/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "base/atomic_file.h"
#include "base/wall_time.h"
#include "clients/study/journal/codec.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;

// Appended to a line truncated by a kill, so that it can never be mistaken for a complete one.
constexpr const char* kTorn = " torn\n";

std::string reason_of(int error) {
  return std::error_code(error, std::generic_category()).message();
}

Problem cannot(int exit_code, const fs::path& path, const std::string& why) {
  return {exit_code, path.string() + ": " + why};
}

Result<void> write_line(int file, const fs::path& path, const std::string& line) {
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t written = ::write(file, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return cannot(EX_IOERR, path, reason_of(errno));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(file) != 0) return cannot(EX_IOERR, path, reason_of(errno));
  return {};
}

Result<std::string> text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return cannot(EX_NOINPUT, path, "cannot be read");
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

/// Until the file is closed or the process ends.
Result<void> lock(int file, const fs::path& path) {
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return {};
  if (errno != EWOULDBLOCK) return cannot(EX_IOERR, path, reason_of(errno));
  return cannot(EX_TEMPFAIL, path, "another hedgehog-study is writing it");
}

}  // namespace

std::string utc_now() { return base::rfc3339(base::unix_ms_now()); }

Result<std::vector<Line>> read_journal(const fs::path& path) {
  const auto text = text_of(path);
  if (!text) return text.error();
  std::vector<Line> lines;
  std::string_view rest = *text;
  for (int number = 1; !rest.empty(); ++number) {
    const auto end = rest.find('\n');
    if (end == std::string_view::npos) break;  // truncated by a kill, without effect
    const std::string_view whole = rest.substr(0, end + 1);
    if (auto line = decode(whole)) {
      lines.push_back(*std::move(line));
    } else if (!whole.ends_with(kTorn)) {  // marked when the run was resumed
      return cannot(EX_DATAERR, path,
                    "line " + std::to_string(number) + " is damaged: " + line.error().message);
    }
    rest.remove_prefix(end + 1);
  }
  return lines;
}

bool has_begun(const fs::path& path) {
  const auto lines = read_journal(path);
  return !lines || !lines->empty();
}

Result<RecordedRun> read_run(const fs::path& path) {
  const auto lines = read_journal(path);
  if (!lines) return lines.error();
  auto run = RecordedRun::replay(*lines);
  if (!run) return cannot(EX_DATAERR, path, run.error().message);
  return run;
}

Result<Journal> Journal::create(const fs::path& path, const RunStarted& header) {
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0) return cannot(EX_CANTCREAT, path, reason_of(errno));
  const Line first{1, utc_now(), header};
  auto begun = lock(file, path);
  if (begun) begun = write_line(file, path, encode(first) + "\n");
  if (!begun) {
    ::close(file);
    return begun.error();
  }
  base::sync_folder(path.parent_path().string());
  auto run = RecordedRun::replay({first});
  if (!run) {
    ::close(file);
    return run.error();
  }
  return Journal(file, path, *std::move(run));
}

Result<Journal> Journal::open(const fs::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (file < 0) return cannot(EX_NOINPUT, path, reason_of(errno));
  if (auto locked = lock(file, path); !locked) {
    ::close(file);
    return locked.error();
  }
  auto run = read_run(path);
  const auto text = text_of(path);
  if (!run || !text) {
    ::close(file);
    return run ? text.error() : run.error();
  }
  if (!text->ends_with('\n')) {
    if (auto ended = write_line(file, path, kTorn); !ended) {
      ::close(file);
      return ended.error();
    }
  }
  return Journal(file, path, *std::move(run));
}

Journal::Journal(int file, fs::path path, RecordedRun run)
    : file_(file), path_(std::move(path)), run_(std::move(run)) {}

Journal::Journal(Journal&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      path_(std::move(other.path_)),
      run_(std::move(other.run_)) {}

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

Result<void> Journal::append(const Event& event) {
  const Line line{run_.lines() + 1, utc_now(), event};
  // An invalid event is never written: a copy is cheap compared with a damaged journal.
  RecordedRun after = run_;
  if (auto taken = after.take(line); !taken)
    return cannot(EX_SOFTWARE, path_, taken.error().message);
  if (auto written = write_line(file_, path_, encode(line) + "\n"); !written) return written;
  run_ = std::move(after);
  return {};
}

}  // namespace hedgehog::study

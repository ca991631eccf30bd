// SPDX-License-Identifier: MIT
// The append-only file of one run: a line of JSON per event, on disk before it takes effect. It is
// never overwritten; a line truncated by a kill is kept and skipped.
#pragma once

#include <filesystem>
#include <vector>

#include "clients/study/journal/recorded_run.h"

namespace hedgehog::study {

/// All complete lines of a journal. EX_NOINPUT; EX_DATAERR with file and line number if one is
/// damaged.
Result<std::vector<Line>> read_journal(const std::filesystem::path& path);
/// False for a journal without events, left by a kill during its creation.
bool has_begun(const std::filesystem::path& path);
/// The lines, replayed.
Result<RecordedRun> read_run(const std::filesystem::path& path);

/// One writer per file (it is locked). Movable.
class Journal {
 public:
  /// Creates a file. EX_CANTCREAT if it exists.
  static Result<Journal> create(const std::filesystem::path& path, const RunStarted& header);
  /// Opens an existing one for appending. EX_TEMPFAIL if another process writes it.
  static Result<Journal> open(const std::filesystem::path& path);

  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;
  ~Journal();

  /// Writes the event, waits until it is on disk, and only then updates the run. EX_IOERR if
  /// writing fails.
  Result<void> append(const Event& event);

  const RecordedRun& run() const noexcept { return run_; }
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  Journal(int file, std::filesystem::path path, RecordedRun run);

  int file_ = -1;
  std::filesystem::path path_;
  RecordedRun run_;
};

/// The present time, as "2026-11-21T15:04:05.123Z".
std::string utc_now();

}  // namespace hedgehog::study

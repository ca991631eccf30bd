// SPDX-License-Identifier: MIT
// The append-only file of one run: a line of JSON an event, on disk before anything follows from
// it. It is never overwritten; a line that a kill tore is left where it is and skipped.
#pragma once

#include <filesystem>
#include <vector>

#include "clients/study/journal/recorded_run.h"

namespace hedgehog::study {

/// All whole lines of a journal. EX_NOINPUT; EX_DATAERR naming file and line when one is damaged.
Result<std::vector<Line>> read_journal(const std::filesystem::path& path);
/// A kill while a run was being created leaves a journal without any event behind.
bool has_begun(const std::filesystem::path& path);
/// The same, replayed.
Result<RecordedRun> read_run(const std::filesystem::path& path);

/// One writer a file (it is locked). Movable.
class Journal {
 public:
  /// A new file. EX_CANTCREAT when there is one already.
  static Result<Journal> create(const std::filesystem::path& path, const RunStarted& header);
  /// Goes on with one. EX_TEMPFAIL when somebody else writes it.
  static Result<Journal> open(const std::filesystem::path& path);

  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;
  ~Journal();

  /// Writes the event, waits until the disk has it, and only then lets the run follow.
  /// EX_IOERR when the disk does not take it.
  Result<void> append(const Event& event);

  const RecordedRun& run() const noexcept { return run_; }
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  Journal(int file, std::filesystem::path path, RecordedRun run);

  int file_ = -1;
  std::filesystem::path path_;
  RecordedRun run_;
};

/// Now, as "2026-11-21T15:04:05.123Z".
std::string utc_now();

}  // namespace hedgehog::study

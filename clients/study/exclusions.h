// SPDX-License-Identifier: MIT
// Runs that the experimenter excluded from the means, and why: journal/exclusions.json beside the
// journals, which it never changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/study_folder.h"

namespace hedgehog::study {

struct Exclusion {
  std::string participant{};
  std::string experiment{};
  int run = 1;
  std::string reason{};  // 1 to 500 characters
  std::string time{};    // of the exclusion, RFC 3339, UTC
  friend bool operator==(const Exclusion&, const Exclusion&) = default;
};

class Exclusions {
 public:
  /// The exclusions of a study; none if there is no file. EX_DATAERR with the error if it is
  /// invalid, not a regular file, or larger than a megabyte: without it the means would be wrong.
  static Result<Exclusions> read(const StudyFolder& study);

  /// nullptr: the run is included.
  const Exclusion* of(const JournalName& name) const;
  /// Replaces an exclusion of the same run.
  void add(const Exclusion& exclusion);
  /// False if there was none.
  bool remove(const JournalName& name);
  /// Atomic: the file is the old or the new one, even if the program is killed. EX_IOERR.
  Result<void> write() const;

 private:
  explicit Exclusions(std::filesystem::path file) : file_(std::move(file)) {}

  std::filesystem::path file_;
  std::vector<Exclusion> all_{};
};

}  // namespace hedgehog::study

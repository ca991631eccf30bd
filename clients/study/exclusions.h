// SPDX-License-Identifier: MIT
// Runs that somebody left out of the means, and why: journal/exclusions.json beside the journals,
// which it never changes.
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
  std::string time{};    // when it was said, RFC 3339, UTC
  friend bool operator==(const Exclusion&, const Exclusion&) = default;
};

class Exclusions {
 public:
  /// Of that study; none where there is no file. EX_DATAERR with what is wrong with it, as when it
  /// is no regular file or larger than a megabyte: means without it would be other means.
  static Result<Exclusions> read(const StudyFolder& study);

  /// nullptr: the run counts.
  const Exclusion* of(const JournalName& name) const;
  /// Takes the place of one of the same run.
  void add(const Exclusion& exclusion);
  /// False when there was none.
  bool remove(const JournalName& name);
  /// The file is the old or the new one, whenever the program is killed. EX_IOERR.
  Result<void> write() const;

 private:
  explicit Exclusions(std::filesystem::path file) : file_(std::move(file)) {}

  std::filesystem::path file_;
  std::vector<Exclusion> all_{};
};

}  // namespace hedgehog::study

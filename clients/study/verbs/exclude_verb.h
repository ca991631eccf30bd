// SPDX-License-Identifier: MIT
// `exclude` and `include`: which runs count for the means.
#pragma once

#include <string>

namespace hedgehog::study {

struct ExcludeOptions {
  std::string participant{};
  std::string experiment{};
  int run = 0;           // 0: the last
  std::string reason{};  // of `exclude`
};
/// EX_NOINPUT when there is no such run.
int run_exclude(const ExcludeOptions& options);
/// EX_NOINPUT when there is no such run, or it counts.
int run_include(const ExcludeOptions& options);

}  // namespace hedgehog::study

// SPDX-License-Identifier: MIT
// `exclude` and `include`: which runs are included in the means.
#pragma once

#include <string>

namespace hedgehog::study {

struct ExcludeOptions {
  std::string participant{};
  std::string experiment{};
  int run = 0;           // 0: the last
  std::string reason{};  // of `exclude`
};
/// EX_NOINPUT if the run does not exist.
int run_exclude(const ExcludeOptions& options);
/// EX_NOINPUT if the run does not exist or is not excluded.
int run_include(const ExcludeOptions& options);

}  // namespace hedgehog::study

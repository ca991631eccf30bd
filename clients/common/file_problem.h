// SPDX-License-Identifier: MIT
// Errors of a file as the error of a program.
#pragma once

#include "base/keys/file_error.h"
#include "clients/common/problem.h"

namespace hedgehog {

/// One line for each error. REQUIRES: errors not empty.
inline Problem problem_of(int exit_code, const keys::FileErrors& errors) {
  std::string lines = keys::to_string(errors);
  lines.pop_back();
  return {exit_code, std::move(lines)};
}

}  // namespace hedgehog

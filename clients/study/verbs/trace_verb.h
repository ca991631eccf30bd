// SPDX-License-Identifier: MIT
// `trace`: a given string of responses to a staircase.
#pragma once

#include <string>

namespace hedgehog::study {

struct TraceOptions {
  std::string experiment{};
  std::string responses{};
  bool json = false;
};

int run_trace(const TraceOptions& options);

/// Prints "hedgehog-study: <message>" to stderr and returns the code.
int report_error(int exit_code, const std::string& message);

}  // namespace hedgehog::study

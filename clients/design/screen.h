// SPDX-License-Identifier: MIT
// Output streams of a verb, and the format.
#pragma once

#include <cstdint>
#include <ostream>

namespace hedgehog::design {

enum class Format : std::uint8_t { kText, kJson, kCsv };

struct Screen {
  std::ostream& out;
  /// Errors and progress.
  std::ostream& err;
  Format format = Format::kText;
};

}  // namespace hedgehog::design

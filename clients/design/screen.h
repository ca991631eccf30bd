// SPDX-License-Identifier: MIT
// Where a verb's answer goes, and in which form.
#pragma once

#include <cstdint>
#include <ostream>

namespace hedgehog::design {

enum class Format : std::uint8_t { kText, kJson, kCsv };

struct Screen {
  std::ostream& out;
  /// Complaints and progress.
  std::ostream& err;
  Format format = Format::kText;
};

}  // namespace hedgehog::design

// SPDX-License-Identifier: MIT
// A journal line as one line of JSON, and back.
#pragma once

#include <string>
#include <string_view>

#include "clients/common/problem.h"
#include "clients/study/journal/event.h"

namespace hedgehog::study {

/// Without the line feed.
std::string encode(const Line& line);
/// EX_DATAERR with what is wrong. Keys that are not known are ignored.
Result<Line> decode(std::string_view text);

}  // namespace hedgehog::study

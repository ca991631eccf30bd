// SPDX-License-Identifier: MIT
// JSON encoding of journal lines.
#pragma once

#include <string>
#include <string_view>

#include "clients/common/problem.h"
#include "clients/study/journal/event.h"

namespace hedgehog::study {

/// Without line feed.
std::string encode(const Line& line);
/// EX_DATAERR with the error. Unknown keys are ignored.
Result<Line> decode(std::string_view text);

}  // namespace hedgehog::study

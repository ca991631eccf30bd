// SPDX-License-Identifier: MIT
// JSON with a comma after the last item of a list or object, as in Apple's own AHAP samples.
// Included by the importers only.
#pragma once

#include <string>
#include <string_view>

namespace hedgehog::client {

/// `text` with a space for each such comma, so that all positions stay the same. Strings and commas
/// without an item before them are unchanged.
std::string without_trailing_commas(std::string_view text);

}  // namespace hedgehog::client

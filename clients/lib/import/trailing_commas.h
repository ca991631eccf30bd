// SPDX-License-Identifier: MIT
// JSON with a comma behind the last item of a list or object, as Apple's own AHAP samples have.
// Included by the importers only.
#pragma once

#include <string>
#include <string_view>

namespace hedgehog::client {

/// `text` with a space for each such comma, so that all else keeps its place. Strings and commas
/// without an item before them stay as they are.
std::string without_trailing_commas(std::string_view text);

}  // namespace hedgehog::client

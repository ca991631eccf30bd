// SPDX-License-Identifier: MIT
// On which line of a JSON text with comments something stands, for complaints about it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hedgehog::study {

/// From 1; beyond the end: the last.
int line_of_byte(std::string_view text, std::size_t offset);

/// Of a key of the outermost object, not of one in a comment or in an object within; 1 when it is
/// not there.
int line_of_key(std::string_view text, const std::string& key);

}  // namespace hedgehog::study

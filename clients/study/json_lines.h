// SPDX-License-Identifier: MIT
// Line numbers in a JSON text with comments, for error messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hedgehog::study {

/// From 1; beyond the end: the last line.
int line_of_byte(std::string_view text, std::size_t offset);

/// The line of a key of the outermost object, not of one in a comment or a nested object; 1 if it
/// is missing.
int line_of_key(std::string_view text, const std::string& key);

}  // namespace hedgehog::study

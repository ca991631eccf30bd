// SPDX-License-Identifier: MIT
// How far one word is from another, for "did you mean".
#pragma once

#include <cstddef>
#include <string_view>

namespace hedgehog::base {

/// Letters to insert, remove or replace to make one of the other (Levenshtein); bytes, case counts.
std::size_t edits_between(std::string_view a, std::string_view b);

}  // namespace hedgehog::base

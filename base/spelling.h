// SPDX-License-Identifier: MIT
// Words as they are meant: whatever their case, and how far one is from another.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hedgehog::base {

/// ASCII only.
std::string lower_case(std::string_view text);

/// Letters to insert, remove or replace to make one of the other (Levenshtein); bytes, case counts.
std::size_t edits_between(std::string_view a, std::string_view b);

}  // namespace hedgehog::base

// SPDX-License-Identifier: MIT
// Lower case, edit distance, and the nearest of some names.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace hedgehog::base {

/// ASCII only.
std::string lower_case(std::string_view text);

/// Letters to insert, remove or replace to make one of the other (Levenshtein); bytes, case counts.
std::size_t edits_between(std::string_view a, std::string_view b);

/// The one of `names` that was probably meant by `text`: at most 2 edits away, or a third of its
/// letters; or the one that only lacks its last part ("duration" for "duration_ms", "--lease" for
/// "--lease-ms"). Empty when none is near, or `text` has more than 64 bytes.
std::string_view nearest(std::string_view text, std::span<const std::string_view> names);

}  // namespace hedgehog::base

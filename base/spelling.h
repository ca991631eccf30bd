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

/// Levenshtein distance in bytes, case-sensitive.
std::size_t edits_between(std::string_view a, std::string_view b);

/// The best match of `names` for a misspelt `text`: within 2 edits or a third of its letters; or a
/// name of which `text` lacks only the last part ("duration" for "duration_ms", "--lease" for
/// "--lease-ms"). Empty if none is close, or if `text` has more than 64 bytes.
std::string_view nearest(std::string_view text, std::span<const std::string_view> names);

}  // namespace hedgehog::base

// SPDX-License-Identifier: MIT
// JSON as programs write it as a rule, in one pass. Inside protocol only; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "protocol/wire/json.h"

namespace hedgehog::protocol {

/// The tree of a text whose strings are ASCII without escapes, whose objects have at most 32
/// members, all of different names, and whose whole numbers have at most 18 digits. nullopt: the
/// text is another, or not JSON, or nested more than `max_nesting` deep; `parse_json` tells these
/// apart, and gives the same tree for a text that is read here.
std::optional<Json> parse_plain_json(std::string_view text, std::size_t max_nesting);

}  // namespace hedgehog::protocol

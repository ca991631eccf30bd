// SPDX-License-Identifier: MIT
// Fast single-pass parser for the common subset of JSON. Internal to protocol; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "protocol/wire/json.h"

namespace hedgehog::protocol {

/// The tree of a text whose strings are ASCII without escapes, whose objects have at most 32
/// members without duplicate names, and whose integers have at most 18 digits. nullopt: any other
/// text, not JSON, or nested more than `max_nesting` deep; `parse_json` distinguishes these, and
/// yields the same tree for a text accepted here.
std::optional<Json> parse_plain_json(std::string_view text, std::size_t max_nesting);

/// The members of a JSON-RPC request, not checked. The strings are parts of the text.
struct PlainRequest {
  std::string_view version;
  std::string_view method;
  /// nullopt: missing.
  std::optional<Json> id{};
  std::optional<Json> params{};
};

/// The request of such a text, whose tree `parse_plain_json` would yield: an object that has
/// `jsonrpc` and `method`, both strings. nullopt: any other text.
std::optional<PlainRequest> parse_plain_request(std::string_view text, std::size_t max_nesting);

}  // namespace hedgehog::protocol

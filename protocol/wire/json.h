// SPDX-License-Identifier: MIT
// JSON text as a tree, and back. Values only; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "protocol/wire/error.h"

namespace hedgehog::protocol {

/// Objects keep the order of their names. Integers that fit are int64, all other numbers double.
struct Json {
  using List = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;
  using Value = std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, List, Object>;

  Value value{nullptr};

  template <class T>
  const T* as() const noexcept {
    return std::get_if<T>(&value);
  }
  /// The member of that name; nullptr if missing or if this is not an object.
  const Json* find(std::string_view name) const noexcept;
  /// "null", "a number", "a string", ... for messages.
  std::string_view kind() const noexcept;
};

/// Exactly one I-JSON text (RFC 7493): valid UTF-8, no duplicate names, numbers representable as
/// double, and at most `max_nesting` levels. Anything else is -32700 with a message that contains
/// the position.
Result<Json> parse_json(std::string_view text, std::size_t max_nesting);

/// Compact JSON on one line.
std::string to_text(const Json& json);

/// Parts of `to_text`, appended to `out`. Invalid UTF-8 becomes U+FFFD, non-finite numbers null; a
/// number is the shortest text that reads back the same.
void append_string(std::string& out, std::string_view text);
void append_number(std::string& out, double number);
void append_integer(std::string& out, std::int64_t number);

}  // namespace hedgehog::protocol

// SPDX-License-Identifier: MIT
// A JSON text as a tree that can be looked through, and the way back. Values only; any thread.
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

/// Objects keep the order of their names. Whole numbers that fit are int64, all others double.
struct Json {
  using List = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;
  using Value = std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, List, Object>;

  Value value{nullptr};

  template <class T>
  const T* as() const noexcept {
    return std::get_if<T>(&value);
  }
  /// The member of that name; null when there is none or this is not an object.
  const Json* find(std::string_view name) const noexcept;
  /// "null", "a number", "a string", ... for messages.
  std::string_view kind() const noexcept;
};

/// I-JSON (RFC 7493) and nothing after it: valid UTF-8, no name twice in an object, numbers that a
/// double can hold, and at most `max_nesting` levels. Anything else is -32700 with a sentence that
/// says where.
Result<Json> parse_json(std::string_view text, std::size_t max_nesting);

/// Compact JSON on one line.
std::string to_text(const Json& json);

/// The pieces of it: appended to `out`. Bytes that are not UTF-8 become U+FFFD, numbers that are
/// not finite null; a number is the shortest text that reads back the same.
void append_string(std::string& out, std::string_view text);
void append_number(std::string& out, double number);
void append_integer(std::string& out, std::int64_t number);

}  // namespace hedgehog::protocol

// SPDX-License-Identifier: MIT
// JSON with comments <-> Value.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <boost/system/result.hpp>

#include "base/keys/file_error.h"
#include "base/keys/value.h"

namespace hedgehog::keys {

/// Maximum size of a file, 1 MiB.
inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 20;

/// Reads `text`, `//` and `/* */` comments allowed. `file` is only for the error, which contains
/// the line. Also rejected: invalid UTF-8, more than kMaxFileBytes, more than 16 levels.
boost::system::result<Value, FileError> parse_json(std::string_view text, const std::string& file);

/// Indented by two; numbers read back the same; ends with a line feed.
std::string to_json(const Value& value);

}  // namespace hedgehog::keys

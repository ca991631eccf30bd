// SPDX-License-Identifier: MIT
// JSON with comments <-> Value.
#pragma once

#include <string>
#include <string_view>

#include <boost/system/result.hpp>

#include "daemon/config/config_error.h"
#include "daemon/config/value.h"

namespace hedgehog::config {

/// Reads `text`, `//` and `/* */` comments allowed. `file` is only for the error, which has the
/// line. Refused besides wrong syntax: invalid UTF-8, more than 1 MiB, more than 16 levels.
boost::system::result<Value, ConfigError> parse_json(std::string_view text,
                                                     const std::string& file);

/// Indented by two, numbers so that they read back the same, a line feed at the end.
std::string to_json(const Value& value);

}  // namespace hedgehog::config

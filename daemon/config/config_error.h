// SPDX-License-Identifier: MIT
// What is wrong with a configuration. All of it is collected, so that one look mends everything.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::config {

struct ConfigError {
  /// A path, or the option of the command line ("--listen").
  std::string file;
  /// From 1; 0 when the error belongs to no line.
  int line = 0;
  /// "limits.current_a"; empty when the error belongs to no key.
  std::string key;
  std::string reason;
  friend bool operator==(const ConfigError&, const ConfigError&) = default;
};

/// "file:line: key: reason".
std::string to_string(const ConfigError& error);

/// Never empty when returned as an error. The daemon prints them and exits with 78 (EX_CONFIG).
using ConfigErrors = std::vector<ConfigError>;

/// One a line.
std::string to_string(const ConfigErrors& errors);

}  // namespace hedgehog::config

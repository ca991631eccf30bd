// SPDX-License-Identifier: MIT
// Errors of a configuration. All are collected, so that they can be fixed at once.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::config {

struct ConfigError {
  /// Path of the file, or command line option ("--listen").
  std::string file;
  /// From 1; 0: no specific line.
  int line = 0;
  /// "limits.current_a"; empty: no specific key.
  std::string key;
  std::string reason;
  friend bool operator==(const ConfigError&, const ConfigError&) = default;
};

/// "file:line: key: reason".
std::string to_string(const ConfigError& error);

/// Never empty when returned as an error. The daemon prints them and exits with 78 (EX_CONFIG).
using ConfigErrors = std::vector<ConfigError>;

/// One error per line.
std::string to_string(const ConfigErrors& errors);

}  // namespace hedgehog::config

// SPDX-License-Identifier: MIT
// hedgehogctl patterns: list, get, put, remove, and import from other formats. Each returns the
// exit code.
#pragma once

#include <string>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

int run_pattern_list(Session& session);
/// Prints it as JSON, for a file.
int run_pattern_get(Session& session, const std::string& name);
/// `file` is in the format that `run_pattern_get` prints.
int run_pattern_put(Session& session, const std::string& file);
int run_pattern_remove(Session& session, const std::string& name);

struct ImportOptions {
  std::string file;
  /// Empty: imported/<the file's name>.
  std::string name;
  /// Stores it in the daemon; otherwise its JSON is printed to stdout.
  bool put = false;
};
/// Opens a connection only to store it. What was left out of the file is reported on stderr.
int run_pattern_import(const CommonOptions& common, const ImportOptions& options);

}  // namespace hedgehog::client

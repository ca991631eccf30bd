// SPDX-License-Identifier: MIT
// hedgehogctl patterns: what there is, one of them, a new one, away with it, and from other
// formats. Each returns the exit code.
#pragma once

#include <string>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

int run_pattern_list(Session& session);
/// Prints it as JSON, for a file.
int run_pattern_get(Session& session, const std::string& name);
/// `file` is what `run_pattern_get` prints.
int run_pattern_put(Session& session, const std::string& file);
int run_pattern_remove(Session& session, const std::string& name);

struct ImportOptions {
  std::string file;
  /// Empty: imported/<the file's name>.
  std::string name;
  /// Put it into the daemon; else its JSON goes to stdout.
  bool put = false;
};
/// Opens a connection only to put it. What was left out of the file is said on stderr.
int run_pattern_import(const CommonOptions& common, const ImportOptions& options);

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// Loads a Config from files and options. Layers in ascending priority: built-in defaults, the
// defaults file, the configuration file, the command line.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <boost/system/result.hpp>

#include "base/keys/file_error.h"
#include "base/regular_file.h"
#include "daemon/config/config.h"
#include "daemon/config/paths.h"

namespace hedgehog::config {

/// Options of the command line.
struct Overrides {
  /// --simulate: selects the simulator, overriding the files.
  bool simulate = false;
  /// --listen A:P, once or more: replaces listen.tcp; the HTTP listener then takes port 0 unless
  /// the configuration file has http.listen.
  std::vector<std::string> listen;
  /// --log-level
  std::optional<std::string> log_level;
};

/// Returns the text of a file, or the error.
using FileReader = std::function<base::FileText(const std::string& path)>;

/// Reads regular files of at most 1 MiB.
base::FileText read_file(const std::string& path);

/// Returns all errors at once. Does not check whether backend "usb" can be started. Blocks on the
/// disk; start-up and reload only. `running`: its geometries are not checked again, which takes up
/// to seconds.
boost::system::result<Config, keys::FileErrors> load_config(const Paths& paths,
                                                            const Overrides& overrides,
                                                            const FileReader& reader = read_file,
                                                            const Config* running = nullptr);

/// Access settings after a reload. The lists of the Unix socket remain those of `running` if only
/// the new ones give `operate` to everybody: clients accepted by the old lists need not be in the
/// socket's group.
AccessSettings reloaded_access(const AccessSettings& running, AccessSettings fresh);

/// JSON with every key and its effective value; loaded as a configuration file it yields the same
/// Config.
std::string print_config(const Config& config);
/// The keys whose effective values differ, and "device" or "simulator.device" if only the content
/// of that file differs; the source of a value is ignored. In the order of print_config.
std::vector<std::string> different_keys(const Config& a, const Config& b);

}  // namespace hedgehog::config

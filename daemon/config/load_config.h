// SPDX-License-Identifier: MIT
// From files and options to a Config. Layers, the later wins: built-in defaults, the defaults file,
// the configuration file, the command line.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <boost/system/result.hpp>

#include "base/regular_file.h"
#include "daemon/config/config.h"
#include "daemon/config/config_error.h"
#include "daemon/config/paths.h"

namespace hedgehog::config {

/// Options of the command line.
struct Overrides {
  /// --simulate: the simulator, whatever the files say.
  bool simulate = false;
  /// --listen A:P, once or more: replaces listen.tcp; the HTTP listener then takes port 0 unless
  /// the configuration file has http.listen.
  std::vector<std::string> listen;
  /// --log-level
  std::optional<std::string> log_level;
};

/// The text of a file, or why there is none.
using FileReader = std::function<base::FileText(const std::string& path)>;

/// Regular files of at most 1 MiB.
base::FileText read_file(const std::string& path);

/// All that is wrong comes back at once. Backend "usb" loads; whether it can be started is the
/// daemon's affair. Blocks on the disk; start-up and reload only. `running`: a configuration whose
/// geometries are not checked again, which takes up to seconds.
boost::system::result<Config, ConfigErrors> load_config(const Paths& paths,
                                                        const Overrides& overrides,
                                                        const FileReader& reader = read_file,
                                                        const Config* running = nullptr);

/// What a reload takes of `fresh`. The lists of the Unix socket stay while everybody would operate
/// by the new ones and not by the `running`: clients whom those let in need not be in the socket's
/// group.
AccessSettings reloaded_access(const AccessSettings& running, AccessSettings fresh);

/// JSON with every key and its value in effect; loaded as a configuration file it gives the same
/// Config.
std::string print_config(const Config& config);
/// The keys whose values in effect differ, and "device" or "simulator.device" where only the
/// content of that file does; where they were read does not count. In the order of print_config.
std::vector<std::string> different_keys(const Config& a, const Config& b);

}  // namespace hedgehog::config

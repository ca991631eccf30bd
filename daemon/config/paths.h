// SPDX-License-Identifier: MIT
// Locations of files. Installed files: share/hedgehog of the program's prefix, else of /usr. Under
// systemd (RUNTIME_DIRECTORY and STATE_DIRECTORY set): /etc/hedgehog, /run/hedgehog and
// /var/lib/hedgehog. Otherwise, also as root: the XDG directories.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hedgehog::config {

struct Paths {
  /// All keys with defaults; installed with the program. Need not exist.
  std::string defaults_file = "/usr/share/hedgehog/hedgehogd.json";
  /// Deviations from the defaults. Need not exist unless `config_file_required` (--config).
  std::string config_file;
  bool config_file_required = false;
  /// Searched for NAME.json in this order, after devices.d beside `config_file`; the program's
  /// prefix before /usr.
  std::vector<std::string> device_directories{"/usr/share/hedgehog/devices.d"};
  /// The dashboard: ../share/hedgehog/www relative to the installed or built program.
  std::string pages_directory = "/usr/share/hedgehog/www";
  std::string state_directory;
  std::string runtime_directory;
};

/// nullopt if the variable is not set or empty.
using Environment = std::function<std::optional<std::string>(const char*)>;

/// Environment of this process; std::getenv is thread-safe while no variable is set.
Environment process_environment();

/// Path of this process's executable; empty: not known.
std::string own_program();

/// XDG: $XDG_CONFIG_HOME/hedgehog (~/.config/hedgehog), $XDG_STATE_HOME/hedgehog
/// (~/.local/state/hedgehog), $XDG_RUNTIME_DIR/hedgehog. Without XDG_RUNTIME_DIR the runtime
/// directory is /tmp/hedgehog-UID, which its creator must own with mode 0700. `config_option`: the
/// argument of --config. `program`: its path, PREFIX/bin/hedgehogd if installed; empty: not known.
Paths find_paths(const Environment& environment, const std::optional<std::string>& config_option,
                 const std::string& program = own_program());

}  // namespace hedgehog::config

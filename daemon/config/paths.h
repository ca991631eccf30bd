// SPDX-License-Identifier: MIT
// Where files are. What is installed with the program: share/hedgehog of its own prefix, else of
// /usr. Started by systemd (RUNTIME_DIRECTORY and STATE_DIRECTORY set): /etc/hedgehog,
// /run/hedgehog and /var/lib/hedgehog. Started by a person, root too: the XDG places.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hedgehog::config {

struct Paths {
  /// Every key with its default; it is installed with the program. Need not exist.
  std::string defaults_file = "/usr/share/hedgehog/hedgehogd.json";
  /// What differs. Need not exist unless `config_file_required` (--config).
  std::string config_file;
  bool config_file_required = false;
  /// Searched for NAME.json in this order; devices.d beside `config_file` comes before all, and the
  /// own prefix's before that of /usr.
  std::vector<std::string> device_directories{"/usr/share/hedgehog/devices.d"};
  /// The dashboard, where the program was installed or built: ../share/hedgehog/www from it.
  std::string pages_directory = "/usr/share/hedgehog/www";
  std::string state_directory;
  std::string runtime_directory;
};

/// nullopt when the variable is not set or empty.
using Environment = std::function<std::optional<std::string>(const char*)>;

/// Of this process; std::getenv is safe as long as nobody sets variables.
Environment process_environment();

/// The path of this process's program; empty: not known.
std::string own_program();

/// XDG: $XDG_CONFIG_HOME/hedgehog (~/.config/hedgehog), $XDG_STATE_HOME/hedgehog
/// (~/.local/state/hedgehog), $XDG_RUNTIME_DIR/hedgehog. Without XDG_RUNTIME_DIR the runtime
/// directory is /tmp/hedgehog-UID, which whoever makes it must make 0700 and own.
/// `config_option`: the argument of --config. `program`: its path, PREFIX/bin/hedgehogd when it is
/// installed; empty: not known.
Paths find_paths(const Environment& environment, const std::optional<std::string>& config_option,
                 const std::string& program = own_program());

}  // namespace hedgehog::config

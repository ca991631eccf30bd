// SPDX-License-Identifier: MIT
#include "daemon/config/paths.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace hedgehog::config {
namespace {

/// systemd lists several directories with colons between them; the first is ours.
std::string first_of(const std::string& list) { return list.substr(0, list.find(':')); }

std::string xdg(const Environment& environment, const char* variable, const char* below_home) {
  // The XDG specification has relative paths ignored.
  if (const auto set = environment(variable); set && set->front() == '/') return *set;
  return environment("HOME").value_or("/tmp") + "/" + below_home;
}

}  // namespace

Environment process_environment() {
  return [](const char* name) -> std::optional<std::string> {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') return std::nullopt;
    return value;
  };
}

Paths find_paths(const Environment& environment, const std::optional<std::string>& config_option) {
  Paths paths;
  const auto runtime = environment("RUNTIME_DIRECTORY");
  const auto state = environment("STATE_DIRECTORY");
  if (runtime && state) {
    paths.config_file = "/etc/hedgehog/hedgehogd.json";
    paths.runtime_directory = first_of(*runtime);
    paths.state_directory = first_of(*state);
  } else {
    paths.config_file = xdg(environment, "XDG_CONFIG_HOME", ".config") + "/hedgehog/hedgehogd.json";
    paths.state_directory = xdg(environment, "XDG_STATE_HOME", ".local/state") + "/hedgehog";
    const auto session = environment("XDG_RUNTIME_DIR");
    paths.runtime_directory = session && session->front() == '/'
                                  ? *session + "/hedgehog"
                                  : "/tmp/hedgehog-" + std::to_string(getuid());
  }
  std::error_code ec;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ec);
  if (!ec) paths.pages_directory = program.parent_path().parent_path() / "share/hedgehog/www";
  if (config_option) {
    paths.config_file = *config_option;
    paths.config_file_required = true;
  }
  return paths;
}

}  // namespace hedgehog::config

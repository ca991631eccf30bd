// SPDX-License-Identifier: MIT
#include "daemon/config/paths.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace hedgehog::config {
namespace {

/// systemd separates several directories by colons; the first one is used.
std::string first_of(const std::string& list) { return list.substr(0, list.find(':')); }

std::string xdg(const Environment& environment, const char* variable, const char* below_home) {
  // By the XDG specification, relative paths are ignored.
  if (const auto set = environment(variable); set && set->front() == '/') return *set;
  return environment("HOME").value_or("/tmp") + "/" + below_home;
}

/// Uses PREFIX/share/hedgehog for the files that exist there.
void use_own_prefix(Paths& paths, const std::filesystem::path& program) {
  if (program.empty()) return;
  const auto share = program.parent_path().parent_path() / "share/hedgehog";
  paths.pages_directory = share / "www";
  std::error_code ignored;
  if (std::filesystem::exists(share / "hedgehogd.json", ignored))
    paths.defaults_file = share / "hedgehogd.json";
  const std::string devices = share / "devices.d";
  if (devices != paths.device_directories.front() && std::filesystem::exists(devices, ignored))
    paths.device_directories.insert(paths.device_directories.begin(), devices);
}

}  // namespace

Environment process_environment() {
  return [](const char* name) -> std::optional<std::string> {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') return std::nullopt;
    return value;
  };
}

std::string own_program() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown).string();
}

Paths find_paths(const Environment& environment, const std::optional<std::string>& config_option,
                 const std::string& program) {
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
  use_own_prefix(paths, program);
  if (config_option) {
    paths.config_file = *config_option;
    paths.config_file_required = true;
  }
  return paths;
}

}  // namespace hedgehog::config

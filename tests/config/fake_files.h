// SPDX-License-Identifier: MIT
// Configuration files in memory.
#pragma once

#include <map>
#include <string>

#include "daemon/config/load_config.h"

namespace hedgehog::config {

inline const std::string kDeviceFile = "/etc/hedgehog/devices.d/mine.json";

struct FakeFiles {
  std::map<std::string, std::string> files;
  Overrides overrides;
  Paths paths{.defaults_file = "/usr/share/hedgehog/hedgehogd.json",
              .config_file = "/etc/hedgehog/hedgehogd.json",
              .config_file_required = false,
              .device_directories = {"/usr/share/hedgehog/devices.d"},
              .state_directory = "/var/lib/hedgehog",
              .runtime_directory = "/run/hedgehog"};

  boost::system::result<Config, keys::FileErrors> load(const Config* running = nullptr) const {
    const FileReader reader = [this](const std::string& path) -> base::FileText {
      const auto found = files.find(path);
      if (found != files.end()) return {found->second, {}};
      return {{}, "No such file or directory", true};
    };
    return load_config(paths, overrides, reader, running);
  }

  /// Uses `text` as the configuration file.
  static FakeFiles with(const std::string& text) {
    FakeFiles fake;
    fake.files["/etc/hedgehog/hedgehogd.json"] = text;
    return fake;
  }

  /// Uses `text` as the device file.
  static FakeFiles with_device(const std::string& text) {
    FakeFiles fake = with(R"({"device": "mine"})");
    fake.files[kDeviceFile] = text;
    return fake;
  }

  /// The errors, one a line; "" when there is none.
  std::string errors() const {
    const auto loaded = load();
    return loaded ? "" : to_string(loaded.error());
  }
};

/// The errors of `text` as the device file.
inline std::string wrong_device(const std::string& text) {
  return FakeFiles::with_device(text).errors();
}

}  // namespace hedgehog::config

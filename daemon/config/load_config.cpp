// SPDX-License-Identifier: MIT
#include "daemon/config/load_config.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/keys/json_text.h"
#include "base/keys/key_tree.h"
#include "daemon/config/access_files.h"
#include "daemon/config/keys/config_keys.h"
#include "daemon/config/keys/device_keys.h"
#include "daemon/config/keys/sensor_keys.h"
#include "daemon/config/keys/unix_role_keys.h"

namespace hedgehog::config {

using namespace keys;

namespace {

class Loader {
 public:
  Loader(const Paths& paths, const FileReader& reader, const Config* running)
      : paths_(paths), reader_(reader) {
    if (running == nullptr) return;
    possible_ = {running->device.geometry, running->simulated_ball().geometry};
  }

  void read_files() {
    read(paths_.defaults_file, false);
    draft_.config.configured = read(paths_.config_file, paths_.config_file_required);
  }

  void apply(const Overrides& overrides) {
    Config& config = draft_.config;
    if (overrides.simulate) config.backend = Backend::kSimulator;
    if (!overrides.listen.empty()) {
      std::vector<Value> addresses;
      for (const std::string& text : overrides.listen) addresses.push_back(Value::of(text));
      option("--listen", "listen.tcp", Value::array(std::move(addresses)));
      const auto http = origins_.find("http.listen");
      const bool chosen = http != origins_.end() && http->second.file == paths_.config_file;
      if (!chosen && config.http.listen) config.http.listen->port = 0;
    }
    if (overrides.log_level) option("--log-level", "log.level", Value::of(*overrides.log_level));
  }

  void resolve() {
    resolve_device();
    resolve_sensors(draft_, origins_, paths_.config_file, errors_);
    resolve_paths();
    check_unix_roles(draft_.config.access.unix_roles, origins_, paths_.config_file, errors_);
    resolve_access(draft_.config, origins_, paths_.config_file, reader_, errors_);
  }

  boost::system::result<Config, FileErrors> finish() {
    if (!errors_.empty()) return std::move(errors_);
    return std::move(draft_.config);
  }

 private:
  /// False if the file does not exist.
  bool read(const std::string& file, bool required) {
    if (file.empty()) return false;
    const base::FileText given = reader_(file);
    if (!given.good()) {
      if (required || !given.missing) errors_.push_back({file, 0, "", given.problem});
      return false;
    }
    draft_.config.files.push_back(file);
    auto root = parse_json(given.text, file);
    if (!root)
      errors_.push_back(root.error());
    else
      read_keys(*root, file, config_keys(), draft_, origins_, errors_);
    return true;
  }

  void option(const std::string& name, const std::string& path, const Value& value) {
    for (const Key<Draft>& key : config_keys()) {
      if (key.path != path) continue;
      const Reason reason = key.read(draft_, value);
      if (!reason.empty()) errors_.push_back({name, 0, "", reason});
    }
  }

  std::vector<std::string> device_candidates(const std::string& name) const {
    const std::filesystem::path beside = std::filesystem::path(paths_.config_file).parent_path();
    if (name.find('/') != std::string::npos) return {(beside / name).lexically_normal()};
    std::vector<std::string> files{beside / "devices.d" / (name + ".json")};
    for (const std::string& directory : paths_.device_directories)
      files.push_back(std::filesystem::path(directory) / (name + ".json"));
    return files;
  }

  void resolve_device() {
    Config& config = draft_.config;
    const std::size_t before = errors_.size();
    config.device = find_device("device", config.device_file);
    const std::string& truth = config.simulator.device_file;
    if (config.backend == Backend::kSimulator && !truth.empty())
      config.simulator.ball = find_device("simulator.device", truth);
    if (errors_.size() == before) check_same_pins();
    // Overrides cannot be checked against the limits of an invalid device file.
    if (errors_.size() != before) return;
    config.limits = tightened(config.device.limits, draft_.limits, origins_, errors_);
    if (errors_.size() == before) check_order(config.limits, origins_, paths_.config_file, errors_);
  }

  /// Pins are identified by number, so the simulated ball must have the same pins as the device.
  void check_same_pins() {
    const Config& config = draft_.config;
    const model::BallGeometry& device = config.device.geometry;
    const model::BallGeometry& ball = config.simulated_ball().geometry;
    if (ball.arrangement == device.arrangement && ball.removed_pins == device.removed_pins &&
        ball.front_pin == device.front_pin)
      return;
    errors_.push_back(error_at(origins_, "simulator.device",
                               "the simulated ball must have the pins of device: the same "
                               "arrangement, removed_pins and front_pin; its magnets and removed "
                               "shields may be others",
                               paths_.config_file));
  }

  /// `key`: the key that refers to the file `name`.
  model::DeviceModel find_device(const std::string& key, const std::string& name) {
    Config& config = draft_.config;
    std::string tried;
    for (const std::string& file : device_candidates(name)) {
      const base::FileText given = reader_(file);
      if (given.missing) {
        tried += (tried.empty() ? "" : " or ") + file;
        continue;
      }
      if (!given.good()) {
        errors_.push_back({file, 0, "", given.problem});
        return {};
      }
      config.files.push_back(file);
      const auto root = parse_json(given.text, file);
      if (root) return read_device(*root, file, possible_, errors_);
      errors_.push_back(root.error());
      return {};
    }
    // The ball of the thesis is built in, so that the executable runs without files.
    if (name != model::DeviceModel{}.model)
      errors_.push_back(error_at(origins_, key, "there is no " + tried, paths_.config_file));
    return {};
  }

  void resolve_paths() {
    Config& config = draft_.config;
    if (config.state_directory.empty()) config.state_directory = paths_.state_directory;
    if (config.http.pages.empty()) config.http.pages = paths_.pages_directory;
    if (config.runtime_directory.empty()) config.runtime_directory = paths_.runtime_directory;
    std::string& socket = config.listen.unix_socket;
    if (!socket.empty() && socket.front() != '/')
      socket = std::filesystem::path(config.runtime_directory) / socket;
    // sockaddr_un has 108 bytes including the terminating NUL.
    if (socket.size() > 107) {
      errors_.push_back(error_at(origins_, "listen.unix",
                                 "the path is longer than the 107 bytes of a socket: " + socket,
                                 paths_.config_file));
    }
    const auto& tcp = config.listen.tcp;
    const auto& http = config.http.listen;
    for (const ListenAddress& other : tcp) {
      if (!http || !conflict(other, *http)) continue;
      const std::string what =
          other.host == http->host
              ? to_string(*http) + " is in listen.tcp too"
              : to_string(*http) + " and " + to_string(other) + " of listen.tcp overlap";
      errors_.push_back(
          error_at(origins_, "http.listen", what + ": take another port", paths_.config_file));
      break;
    }
    if (tcp.empty() && socket.empty()) {
      errors_.push_back(error_at(origins_, "listen.tcp",
                                 "the daemon would have no listener: listen.unix is null too",
                                 paths_.config_file));
    }
  }

  const Paths& paths_;
  const FileReader& reader_;
  KnownGeometries possible_;
  Draft draft_;
  Origins origins_;
  FileErrors errors_;
};

/// The draft for printing: all limits in effect are set explicitly.
Draft as_draft(const Config& config) {
  Draft draft{config, {}, config.imu};
  for (std::size_t i = 0; i < kLimitFields.size(); ++i)
    draft.limits[i] = config.limits.*kLimitFields[i].member;
  return draft;
}

}  // namespace

boost::system::result<Config, FileErrors> load_config(const Paths& paths,
                                                      const Overrides& overrides,
                                                      const FileReader& reader,
                                                      const Config* running) {
  Loader loader(paths, reader, running);
  loader.read_files();
  loader.apply(overrides);
  loader.resolve();
  return loader.finish();
}

AccessSettings reloaded_access(const AccessSettings& running, AccessSettings fresh) {
  if (access::has_everybody(fresh.unix_roles.operate) &&
      !access::has_everybody(running.unix_roles.operate))
    fresh.unix_roles = running.unix_roles;
  return fresh;
}

base::FileText read_file(const std::string& path) {
  return base::read_regular_file(path, kMaxFileBytes);
}

std::string print_config(const Config& config) {
  return to_json(write_keys(config_keys(), as_draft(config)));
}

std::vector<std::string> different_keys(const Config& a, const Config& b) {
  const Draft draft_a = as_draft(a);
  const Draft draft_b = as_draft(b);
  std::vector<std::string> paths;
  for (const Key<Draft>& key : config_keys()) {
    const bool other_file =
        (key.path == "device" && !(a.device == b.device)) ||
        (key.path == "simulator.device" && !(a.simulator.ball == b.simulator.ball));
    if (other_file || to_json(key.write(draft_a)) != to_json(key.write(draft_b)))
      paths.push_back(key.path);
  }
  return paths;
}

}  // namespace hedgehog::config

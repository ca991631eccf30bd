// SPDX-License-Identifier: MIT
// The complete, checked configuration: no optional value refers to another source. Each key is
// documented in config/hedgehogd.json. A plain value; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "access/token_file.h"
#include "access/unix_roles.h"
#include "daemon/config/listen_address.h"
#include "daemon/config/sensor_settings.h"
#include "daemon/device/simulator/front_end.h"
#include "model/device_model.h"
#include "model/limit/limits.h"

namespace hedgehog::config {

enum class Backend : std::uint8_t { kSimulator, kUsb };
enum class ArmAtStart : std::uint8_t { kAfterCleanStop, kNever };
enum class LogLevel : std::uint8_t { kDebug, kInfo, kWarning, kError };

struct ListenSettings {
  std::vector<ListenAddress> tcp{{"127.0.0.1", 7586}, {"::1", 7586}};
  /// Absolute path; empty: no Unix socket.
  std::string unix_socket = "hedgehogd.sock";
  friend bool operator==(const ListenSettings&, const ListenSettings&) = default;
};

struct HttpSettings {
  std::optional<ListenAddress> listen{{"127.0.0.1", 7587}};
  /// Origins of web pages that may connect in addition to those of this machine,
  /// "https://host[:port]".
  std::vector<std::string> allow_origins;
  /// The dashboard's folder.
  std::string pages;
  friend bool operator==(const HttpSettings&, const HttpSettings&) = default;
};

/// Access from other machines, and roles of users on the Unix socket. The content of the files is
/// not printed.
struct AccessSettings {
  /// Absolute paths.
  std::string tokens_file;
  std::string certificate_file;
  std::string key_file;
  access::Tokens tokens;
  /// Matching certificate and key; empty without a TLS listener.
  std::string certificate_pem;
  std::string key_pem;
  access::UnixRoles unix_roles{};
  friend bool operator==(const AccessSettings&, const AccessSettings&) = default;
};

struct SimulatorSettings {
  double ambient_c = 25.0;
  /// Temperature of the whole ball at start; nullopt: from the state directory, else ambient.
  std::optional<double> start_temperature_c;
  /// True: the simulated board is the process `hedgehog-simboard` instead of a thread.
  bool process = false;
  /// The board's electronics, and its number of thermistors, 1 or 3; nullopt: three with in_line,
  /// one otherwise.
  device::FrontEndKind front_end = device::FrontEndKind::kInLine;
  std::optional<int> thermistors;
  /// Seed of all noise and of the electronics' tolerances; 0: typical parts.
  std::uint32_t seed = 0;
  /// Device file of the simulated ball, as Config::device_file; empty: the daemon's own.
  std::string device_file;
  /// The content of that file; nullopt: the simulated ball matches the device file.
  std::optional<model::DeviceModel> ball;
  friend bool operator==(const SimulatorSettings&, const SimulatorSettings&) = default;
};

struct ConnectionSettings {
  std::size_t max = 64;
  /// Unsent bytes of one connection: reading of requests pauses while its responses exceed an
  /// eighth of it, telemetry is dropped at half of it, the connection is closed at all of it.
  std::size_t queue_bytes = 1u << 20;
  /// A client whose requests are paused is disconnected if it reads nothing for so long, s.
  int write_timeout_s = 10;
  /// So many clients are served by system calls of their own, which is best for a few; the plain
  /// sockets of further ones use io_uring where the kernel has it and allows it.
  std::size_t io_uring_after = 8;
  friend bool operator==(const ConnectionSettings&, const ConnectionSettings&) = default;
};

struct Config {
  Backend backend = Backend::kSimulator;
  /// Name of the device file, or its path when it has a slash.
  std::string device_file = "hedgehog-86";
  /// Content of that file.
  model::DeviceModel device;
  /// The device's limits as tightened here; is_within(limits, device.limits).
  model::Limits limits;
  ArmAtStart arm_at_start = ArmAtStart::kAfterCleanStop;
  ImuSource imu = ImuType::kSimulator;
  ImuFitting imu_fitting;
  ThermometerSettings thermometer;
  /// Output gain at the first start, 0..1; `output.set_gain` changes and stores it.
  double gain = 1.0;
  ListenSettings listen;
  HttpSettings http;
  AccessSettings access;
  ConnectionSettings connections;
  /// Maximum rate of `telemetry.subscribe`, 1..200.
  int telemetry_max_rate_hz = 200;
  LogLevel log_level = LogLevel::kInfo;
  SimulatorSettings simulator;
  /// True parameters of the simulated ball; `device` contains the daemon's assumptions.
  const model::DeviceModel& simulated_ball() const noexcept {
    return simulator.ball ? *simulator.ball : device;
  }
  /// Absolute paths.
  std::string state_directory;
  std::string runtime_directory;

  /// The files read, in order; not printed. `configured` is false without a configuration file
  /// (defaults only): the daemon then reports that it simulates.
  std::vector<std::string> files;
  bool configured = false;
};

}  // namespace hedgehog::config

// SPDX-License-Identifier: MIT
// The assembled process: threads, server, listeners, signals.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <optional>
#include <string>

#include "daemon/announcement.h"
#include "daemon/config/load_config.h"
#include "daemon/config_reload.h"
#include "daemon/device/cpu_latency.h"
#include "daemon/device_list.h"
#include "daemon/device_threads.h"
#include "daemon/options.h"
#include "daemon/server/device/ball_warnings.h"
#include "daemon/server/device/device_view.h"
#include "daemon/server/device/event_wait.h"
#include "daemon/server/device/file_state_store.h"
#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/disk/pattern_files.h"
#include "daemon/server/disk/pattern_library.h"
#include "daemon/server/disk/saved_state.h"
#include "daemon/server/history/event_history.h"
#include "daemon/server/history/telemetry_file.h"
#include "daemon/server/history/trip_recordings.h"
#include "daemon/server/net/listener.h"
#include "daemon/server/rpc/server.h"
#include "daemon/service_manager.h"

namespace hedgehog::daemon {

/// main's thread is the io thread.
class Daemon {
 public:
  /// Opens the listening sockets and starts board and link. Throws std::exception with a sentence
  /// for display on failure.
  Daemon(const Options& options, const config::Paths& paths, const config::Config& config);

  /// Runs until SIGTERM or SIGINT. Returns the exit code.
  int run();

 private:
  boost::asio::awaitable<void> pump();
  boost::asio::awaitable<void> handle_signals();
  boost::asio::awaitable<void> shut_down(std::string reason);
  /// The new configuration, or the errors in it.
  void apply(ConfigReload::Loaded fresh);
  void on_event(const control::Event& event, const server::Effect* effect);
  void log_state(const control::Event& event);
  void log_start();
  void start_listening();
  std::string status_line() const;

  Options options_;
  config::Config config_;
  boost::asio::io_context io_{1};
  boost::asio::signal_set signals_;
  ServiceManager manager_;
  device::CpuLatency cpu_latency_;
  server::Listener listener_;
  std::optional<server::SavedState> saved_;
  DeviceThreads threads_;
  ConfigReload reload_;
  server::DiskThread scan_thread_{"scan"};
  server::DiskThread disk_;
  server::EventWait event_wait_;
  server::DeviceView device_view_;
  server::FileStateStore state_store_;
  server::BallWarnings warnings_;
  DeviceList devices_;
  server::PatternFiles pattern_files_;
  server::PatternLibrary patterns_;
  server::EventHistory history_;
  server::TripRecordings recordings_;
  server::TelemetryFile telemetry_file_;
  server::Server server_;
  /// Exists while other machines can reach a listener.
  std::optional<Announcement> announcement_;
  bool ready_ = false;
  /// Event of a ball not armed at its first detection, until it is armed or clients are accepted.
  std::optional<control::Event> start_blocker_;
  bool stopping_ = false;
};

/// Settings of the controller at the start, from configuration and saved state.
struct StartState {
  control::ControlSettings settings;
  /// Temperature of the simulated ball.
  double simulated_c = 25.0;
};
StartState start_state(const config::Config& config, const std::optional<server::SavedState>& saved,
                       const server::BootTime& now);

}  // namespace hedgehog::daemon

// SPDX-License-Identifier: MIT
// The whole daemon, put together: threads, server, doors, signals.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <optional>
#include <string>

#include "daemon/config/load_config.h"
#include "daemon/device_list.h"
#include "daemon/machinery.h"
#include "daemon/options.h"
#include "daemon/server/disk_thread.h"
#include "daemon/server/event_history.h"
#include "daemon/server/listener.h"
#include "daemon/server/machine.h"
#include "daemon/server/pattern_files.h"
#include "daemon/server/pattern_library.h"
#include "daemon/server/saved_state.h"
#include "daemon/server/server.h"
#include "daemon/server/state_keeper.h"
#include "daemon/server/trip_recordings.h"
#include "daemon/service_manager.h"

namespace hedgehog::daemon {

/// main's thread is the io thread.
class Daemon {
 public:
  /// Opens the doors and starts board and link. Throws std::exception with a sentence for a person
  /// when it cannot.
  Daemon(const Options& options, const config::Paths& paths, const config::Config& config);

  /// Until SIGTERM or SIGINT. Returns the exit code.
  int run();

 private:
  boost::asio::awaitable<void> pump();
  boost::asio::awaitable<void> obey_signals();
  boost::asio::awaitable<void> leave(std::string reason);
  void reload();
  void heard(const control::Event& event, const server::Effect* effect);
  void log_state(const control::Event& event);
  void introduce();
  void open_doors();
  std::string status_line() const;

  Options options_;
  config::Paths paths_;
  config::Config config_;
  boost::asio::io_context io_{1};
  boost::asio::signal_set signals_;
  ServiceManager manager_;
  server::Listener listener_;
  std::optional<server::SavedState> saved_;
  Machinery machinery_;
  server::DiskThread look_{"look"};
  server::DiskThread disk_;
  server::Machine machine_;
  server::StateKeeper keeper_;
  DeviceList devices_;
  server::PatternFiles pattern_files_;
  server::PatternLibrary patterns_;
  server::EventHistory history_;
  server::TripRecordings recordings_;
  server::Server server_;
  bool ready_ = false;
  /// Why the ball was not armed at its first sight, until it is or the doors open.
  std::optional<control::Event> first_sight_;
  bool leaving_ = false;
};

/// What the controller is told at the start, from configuration and from what was saved.
struct StartState {
  control::ControlSettings settings;
  /// Temperature of the simulated ball.
  double simulated_c = 25.0;
};
StartState start_state(const config::Config& config, const std::optional<server::SavedState>& saved,
                       double wall_time_s);

}  // namespace hedgehog::daemon

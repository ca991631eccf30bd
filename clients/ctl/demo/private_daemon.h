// SPDX-License-Identifier: MIT
// A separate hedgehogd: a simulated ball, a Unix socket in a temporary folder, no port. Independent
// of other running daemons.
#pragma once

#include <sys/types.h>

#include <string>

#include "clients/lib/client_error.h"

namespace hedgehog::client {

/// One thread. The destructor ends the daemon (SIGTERM, and waits for it) and removes the folder.
class PrivateDaemon {
 public:
  /// Starts hedgehogd, searched for in the folder of this program, in the build folder, then in
  /// PATH, and waits until it listens. The ball starts at `start_temperature_c`, the ambient is
  /// `ambient_c`.
  static Outcome<PrivateDaemon> start(double start_temperature_c, double ambient_c);

  PrivateDaemon(PrivateDaemon&& other) noexcept;
  PrivateDaemon& operator=(PrivateDaemon&&) = delete;
  ~PrivateDaemon();

  /// Path of its socket, for `--address`.
  const std::string& socket() const noexcept { return socket_; }
  /// Ends it; returns its exit code, -1 if it was killed by a signal.
  int stop();

 private:
  PrivateDaemon() = default;

  std::string folder_;
  std::string socket_;
  pid_t process_ = -1;
};

}  // namespace hedgehog::client

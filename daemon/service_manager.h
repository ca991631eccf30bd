// SPDX-License-Identifier: MIT
// systemd readiness, watchdog and status notifications. No-op outside systemd.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace hedgehog::daemon {

/// io thread only.
class ServiceManager {
 public:
  ServiceManager();

  void ready(const std::string& status);
  /// Sent on a change only.
  void status(const std::string& status);
  void reloading();
  void stopping();
  /// Feeds the watchdog at its interval while `heartbeat` increases: if the control thread stops,
  /// systemd restarts the daemon.
  void alive(std::uint64_t heartbeat);

 private:
  std::chrono::steady_clock::duration interval_{};
  std::chrono::steady_clock::time_point fed_{};
  std::uint64_t heartbeat_ = 0;
  std::string status_;
};

}  // namespace hedgehog::daemon

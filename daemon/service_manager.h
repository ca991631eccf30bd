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
  /// Sent when it has changed.
  void status(const std::string& status);
  void reloading();
  void stopping();
  /// Feeds the watchdog, as often as it wants, while `heartbeat` rises: a control thread that
  /// stands still lets systemd restart us.
  void alive(std::uint64_t heartbeat);

 private:
  std::chrono::steady_clock::duration interval_{};
  std::chrono::steady_clock::time_point fed_{};
  std::uint64_t heartbeat_ = 0;
  std::string status_;
};

}  // namespace hedgehog::daemon

// SPDX-License-Identifier: MIT
#include "daemon/service_manager.h"

#include <systemd/sd-daemon.h>

#include "daemon/device/tick_clock.h"

namespace hedgehog::daemon {

ServiceManager::ServiceManager() {
  std::uint64_t period_us = 0;
  if (sd_watchdog_enabled(0, &period_us) > 0) interval_ = std::chrono::microseconds(period_us / 2);
}

void ServiceManager::ready(const std::string& status) {
  status_ = status;
  sd_notify(0, ("READY=1\nSTATUS=" + status).c_str());
}

void ServiceManager::status(const std::string& status) {
  if (status != status_) {
    status_ = status;
    sd_notify(0, ("STATUS=" + status).c_str());
  }
}

void ServiceManager::reloading() {
  const std::int64_t now_us = device::monotonic_ns() / 1000;
  sd_notify(0, ("RELOADING=1\nMONOTONIC_USEC=" + std::to_string(now_us)).c_str());
}

void ServiceManager::stopping() { sd_notify(0, "STOPPING=1\nSTATUS=coils off, stopping"); }

void ServiceManager::alive(std::uint64_t heartbeat) {
  const auto now = std::chrono::steady_clock::now();
  if (interval_.count() == 0 || heartbeat == heartbeat_ || now - fed_ < interval_) return;
  heartbeat_ = heartbeat;
  fed_ = now;
  sd_notify(0, "WATCHDOG=1");
}

}  // namespace hedgehog::daemon

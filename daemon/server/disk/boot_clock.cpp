// SPDX-License-Identifier: MIT
#include "daemon/server/disk/boot_clock.h"

#include <algorithm>
#include <ctime>
#include <fstream>

namespace hedgehog::server {
namespace {

std::string read_boot_id() {
  std::string id;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), id);
  return id;
}

}  // namespace

BootTime boot_time_now() {
  static const std::string boot_id = read_boot_id();
  timespec now{};
  if (clock_gettime(CLOCK_BOOTTIME, &now) != 0) return {};
  return {boot_id, static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec)};
}

double seconds_between(const BootTime& earlier, const BootTime& now) noexcept {
  if (earlier.boot_id.empty() || now.boot_id.empty()) return 0.0;
  const double since_boot_s = std::max(0.0, now.seconds);
  if (earlier.boot_id != now.boot_id) return since_boot_s;
  return std::max(0.0, now.seconds - earlier.seconds);
}

}  // namespace hedgehog::server

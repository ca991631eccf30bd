// SPDX-License-Identifier: MIT
// Time since the boot of the machine, suspend included: the only clock by which a ball is credited
// with cooling while the daemon was not running, because unlike the time of day it cannot be set.
#pragma once

#include <string>

namespace hedgehog::server {

/// A point in time of one boot.
struct BootTime {
  std::string boot_id;   // of the kernel, 1 to 64 characters; empty: unknown
  double seconds = 0.0;  // CLOCK_BOOTTIME, s, 0 or more

  friend bool operator==(const BootTime&, const BootTime&) = default;
};

/// Reads /proc/sys/kernel/random/boot_id once per process. Any thread.
BootTime boot_time_now();

/// Minimum time from `earlier` to `now`, s: their difference within one boot; the time since this
/// boot when `earlier` is of another one; 0 when that is unknown or they contradict.
double seconds_between(const BootTime& earlier, const BootTime& now) noexcept;

}  // namespace hedgehog::server

// SPDX-License-Identifier: MIT
// Time since the machine booted, suspend included: the only clock by which a ball is credited with
// cooling while the daemon was not running, since nobody can set it. The time of day can be set.
#pragma once

#include <string>

namespace hedgehog::server {

/// A point in time of one boot.
struct BootTime {
  /// Of the kernel, 1 to 64 characters; empty: unknown.
  std::string boot_id;
  /// CLOCK_BOOTTIME, s, 0 or more.
  double seconds = 0.0;

  friend bool operator==(const BootTime&, const BootTime&) = default;
};

/// Reads /proc/sys/kernel/random/boot_id, once a process. Any thread.
BootTime boot_time_now();

/// The least that has passed from `earlier` to `now`, s: their difference within one boot; all of
/// this boot when `earlier` is of another one; 0 when that is unknown or they contradict.
double seconds_between(const BootTime& earlier, const BootTime& now) noexcept;

}  // namespace hedgehog::server

// SPDX-License-Identifier: MIT
// `hedgehog-racer lap`: the built-in driver on the home track, felt on the ball or only told.
#pragma once

#include <functional>
#include <vector>

#include "clients/lib/address.h"

namespace hedgehog::racer {

struct LapOptions {
  std::vector<client::Address> addresses;  // of the daemon; empty: no ball, as fast as it goes
  double seconds = 120.0;                  // of the race
  double speed = 1.0;                      // of the race, as the daemon's --speed
  bool json = false;
};

/// The exit code: 0, 1 when the ball tripped, 69 when there is none, it is not armed or another's,
/// 130 when `interrupted` says so.
int drive_laps(const LapOptions& options, const std::function<bool()>& interrupted);

}  // namespace hedgehog::racer

// SPDX-License-Identifier: MIT
// `hedgehog-racer lap`: the built-in driver on the home track, felt on the ball or only printed.
#pragma once

#include <functional>
#include <vector>

#include "clients/lib/address.h"

namespace hedgehog::racer {

struct LapOptions {
  std::vector<client::Address> addresses;  // of the daemon; empty: no ball, at maximum speed
  double seconds = 120.0;                  // of the race
  double speed = 1.0;                      // of the race, as the daemon's --speed
  bool json = false;
};

/// Returns the exit code: 0, 1 if the ball tripped, 69 if it is absent, not armed or claimed by
/// another client, 130 if `interrupted` returned true.
int drive_laps(const LapOptions& options, const std::function<bool()>& interrupted);

}  // namespace hedgehog::racer

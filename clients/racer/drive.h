// SPDX-License-Identifier: MIT
// `hedgehog-racer`: the player or the built-in driver on the home track, displayed on the page and
// felt on the ball.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/lib/address.h"
#include "clients/racer/server/hub.h"
#include "clients/racer/server/messages.h"

namespace hedgehog::racer {

struct DriveOptions {
  std::vector<client::Address> addresses;  // of the daemon; empty: no ball
  HubSettings page;
  /// Initial mode; nullopt: the ball once its orientation is known, the keyboard until then.
  std::optional<Mode> mode{};
};

/// Parses "127.0.0.1:7585", "[::1]:0". nullopt: not an address with a port.
std::optional<HubSettings> listen_at(const std::string& text);

/// Runs until `interrupted`. Returns the exit code: 0, 73 if it cannot listen.
int drive(const DriveOptions& options, const std::function<bool()>& interrupted);

}  // namespace hedgehog::racer

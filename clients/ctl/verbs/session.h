// SPDX-License-Identifier: MIT
// What every verb of hedgehogctl starts from: a connection, and how its user wants to be spoken to.
#pragma once

#include <optional>
#include <string>

#include "clients/ctl/exit_code.h"
#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/status_screen.h"
#include "clients/lib/connection.h"

namespace hedgehog::client {

/// Options that stand before or behind any verb.
struct CommonOptions {
  /// --address; empty: where the daemon usually is.
  std::optional<std::string> address;
  /// --json: for programs.
  bool json = false;
};

struct Session {
  Connection connection;
  bool json = false;
  ScreenStyle style;
};

/// Connects and introduces itself.
Outcome<Session> open_session(const CommonOptions& options);

/// hello, device.describe and device.status in one.
Outcome<Ball> look(Connection& connection);

}  // namespace hedgehog::client

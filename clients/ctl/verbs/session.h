// SPDX-License-Identifier: MIT
// The context of every verb of hedgehogctl: a connection and the output style.
#pragma once

#include <optional>
#include <string>

#include "clients/ctl/exit_code.h"
#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/status_screen.h"
#include "clients/lib/connection.h"

namespace hedgehog::client {

/// Options before or after any verb.
struct CommonOptions {
  /// --address; empty: the default addresses.
  std::optional<std::string> address;
  /// --json: output for programs.
  bool json = false;
};

struct Session {
  Connection connection;
  bool json = false;
  ScreenStyle style;
};

/// Opens a connection.
Outcome<Session> open_session(const CommonOptions& options);

/// hello, device.describe and device.status in one.
Outcome<Ball> look(Connection& connection);

}  // namespace hedgehog::client

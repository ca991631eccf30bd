// SPDX-License-Identifier: MIT
// Results of a search for balls.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/ctl/discover/local_daemons.h"
#include "clients/ctl/discover/network_daemons.h"
#include "protocol/methods.h"

namespace hedgehog::client {

/// A running daemon of this machine.
struct RespondingDaemon {
  LocalDaemon daemon;
  /// nullopt: no response, or access denied for this user.
  std::optional<protocol::HelloResult> hello;
  /// The board's serial number; nullopt: a simulated ball, or a board that has none.
  std::optional<std::string> serial;
  /// Without `hello`: the reason.
  std::string failure;
};

struct Discovery {
  std::vector<RespondingDaemon> local;
  NetworkSearch network;
};

/// The daemons of this machine whose socket a process listens on, including those that do not
/// respond or deny access. Does not wait for any of them.
std::vector<LocalDaemon> running_daemons(const Environment& environment = process_environment);

/// Sends a hello to each of `running_daemons`.
std::vector<RespondingDaemon> search_machine(const Environment& environment = process_environment);

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// Everything that a search for balls has found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/ctl/discover/local_daemons.h"
#include "clients/ctl/discover/network_daemons.h"
#include "protocol/methods.h"

namespace hedgehog::client {

/// A daemon of this machine that a process serves.
struct RespondingDaemon {
  LocalDaemon daemon;
  /// nullopt: it did not respond, or not to this user.
  std::optional<protocol::HelloResult> hello;
  /// The board's serial number; nullopt: a simulated ball, or a board that has none.
  std::optional<std::string> serial;
  /// Without `hello`: why.
  std::string failure;
};

struct Discovery {
  std::vector<RespondingDaemon> local;
  NetworkSearch network;
};

/// The daemons of this machine whose socket a process serves, even one that does not respond or
/// does not let this user in. Waits for none of them.
std::vector<LocalDaemon> running_daemons(const Environment& environment = process_environment);

/// Introduces this client to each of `running_daemons`.
std::vector<RespondingDaemon> search_machine(const Environment& environment = process_environment);

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// The daemons of this machine, by the sockets in their runtime directories.
#pragma once

#include <string>
#include <vector>

#include "clients/lib/address.h"

namespace hedgehog::client {

struct LocalDaemon {
  /// The instance of hedgehogd@INSTANCE.service; "hedgehogd" for the service of a single ball.
  std::string instance;
  std::string socket;
};

/// hedgehogd's socket and those of its instances, RUNTIME/INSTANCE/hedgehogd.sock, by name. RUNTIME
/// is RUNTIME_DIRECTORY if set; otherwise /run/hedgehog and then the runtime directory of this user
/// (XDG_RUNTIME_DIR/hedgehog, without that variable /tmp/hedgehog-UID). Includes sockets left
/// behind by killed daemons.
std::vector<LocalDaemon> local_daemons(const Environment& environment = process_environment);

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// Credentials of a Unix socket's peer.
#pragma once

#include <optional>

#include "access/peer.h"

namespace hedgehog::server {

/// Those of the process that connected to the Unix socket `descriptor`; nullopt: not provided. No
/// supplementary groups before Linux 4.13. Does not block or query a user database. Any thread.
std::optional<access::Peer> peer_of(int descriptor);

}  // namespace hedgehog::server

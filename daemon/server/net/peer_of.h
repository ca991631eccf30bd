// SPDX-License-Identifier: MIT
// Credentials of a Unix socket's peer.
#pragma once

#include <optional>

#include "access/peer.h"

namespace hedgehog::server {

/// Of the process that connected to the Unix socket `descriptor`; nullopt: the system does not
/// tell. Without supplementary groups before Linux 4.13. Does not block and asks no database of
/// users. Any thread.
std::optional<access::Peer> peer_of(int descriptor);

}  // namespace hedgehog::server

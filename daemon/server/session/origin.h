// SPDX-License-Identifier: MIT
// Origin of a client, for the log.
#pragma once

#include <string>

#include "daemon/server/session/session.h"

namespace hedgehog::server {

std::string user_text(const access::Peer& peer);  // "user 1000"

/// "192.0.2.7:5000", "unix (user 1000, process 4711)". Any thread.
std::string origin_text(const Session& session);

}  // namespace hedgehog::server

// SPDX-License-Identifier: MIT
#include "daemon/server/session/origin.h"

namespace hedgehog::server {

std::string user_text(const access::Peer& peer) { return "user " + std::to_string(peer.user); }

std::string origin_text(const Session& session) {
  if (session.address) return *session.address;
  if (!session.peer) return session.transport;
  std::string text = session.transport + " (" + user_text(*session.peer);
  if (session.peer->process > 0) text += ", process " + std::to_string(session.peer->process);
  return text + ")";
}

}  // namespace hedgehog::server

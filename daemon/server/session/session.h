// SPDX-License-Identifier: MIT
// One client: identity, role and subscriptions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "access/peer.h"
#include "access/token.h"
#include "daemon/server/session/write_queue.h"
#include "model/tick.h"
#include "protocol/methods.h"
#include "protocol/values/status_keys.h"
#include "protocol/wire/role.h"

namespace hedgehog::server {

/// Never used twice while the daemon runs; 0 is none.
using ConnectionId = std::int64_t;

/// Where a session's lines go: a socket, or a list in tests.
class Sink {
 public:
  virtual ~Sink() = default;
  /// `line` without LF. May end the session when its client does not read (later, never inside
  /// this call).
  virtual void send(std::string line, LineKind kind) = 0;
  /// The same for telemetry that others get too.
  virtual void send_telemetry(const SharedLine& line) {
    send(line->substr(0, line->size() - 1), LineKind::kTelemetry);
  }
  /// Nothing more will come: what was sent may go out, then the session is over.
  virtual void finish() = 0;
};

struct TelemetrySubscription {
  protocol::StatusKeys fields;
  model::Tick period = 100;
  model::Tick next = 0;
  bool due = false;  // it waits for its turn
};

struct EventSubscription {
  std::vector<std::string> types;  // empty: all
  protocol::Scope scope = protocol::Scope::kMine;
};

/// io thread only.
struct Session {
  ConnectionId id = 0;
  std::string transport;  // "tcp", "unix"
  std::optional<std::string> address;
  /// On the Unix socket; nullopt there: the system does not tell.
  std::optional<access::Peer> peer;
  protocol::Role role = protocol::Role::kPlay;
  /// What it has shown; nullopt: the role is that of its transport, or of its user.
  std::optional<access::Token> token;
  /// Nothing but `hello` with a token is carried out: it needs one, its own was revoked, or its
  /// user has no role.
  bool locked = false;
  /// The daemon has ended it: no token unlocks it, what comes until its socket is closed is
  /// refused.
  bool ended = false;
  std::string client;
  model::Tick since = 0;
  std::optional<TelemetrySubscription> telemetry;
  std::optional<EventSubscription> events;
  Sink* sink = nullptr;
  /// A batch whose answers are longer is not carried out further.
  std::size_t batch_bytes = std::size_t{512} << 10;
  /// Of answers that wait for others of their batch.
  std::size_t open_bytes = 0;
  /// When the request that is carried out was read, CLOCK_MONOTONIC ns; 0: not known.
  std::int64_t received_ns = 0;
  /// Its requests that wait until it takes its responses.
  std::size_t held = 0;
  /// So many of them, the first ones, were sent before an emergency stop that has been carried out,
  /// or before the end of the connection: they start nothing any more.
  std::size_t overtaken = 0;
};

}  // namespace hedgehog::server

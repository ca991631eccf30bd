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

/// Unique while the daemon runs; 0 is none.
using ConnectionId = std::int64_t;

/// kSoon: together with those of other clients, when the io thread has finished what it does at
/// present. kAtOnce: before what takes long.
enum class Flush : std::uint8_t { kSoon, kAtOnce };

/// Destination of a session's lines: a socket, or a list in tests.
class Sink {
 public:
  virtual ~Sink() = default;
  /// `line` without LF. May end the session if its client does not read (later, never inside this
  /// call).
  virtual void send(std::string line, LineKind kind) = 0;
  /// The same for telemetry shared with other clients.
  virtual void send_telemetry(const SharedLine& line) {
    send(line->substr(0, line->size() - 1), LineKind::kTelemetry);
  }
  /// Writes the queued lines without waiting for more (see `Server::flush_after_pump`); neither
  /// sends lines nor ends a session within this call.
  virtual void flush(Flush when) = 0;
  /// No more lines follow: the queued ones may be sent, then the session ends.
  virtual void finish() = 0;
};

struct TelemetrySubscription {
  protocol::StatusKeys fields;
  model::Tick period = 100;
  model::Tick next = 0;
  bool expected = false;  // by the publisher, at `next`
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
  /// On the Unix socket; nullopt there: not provided by the system.
  std::optional<access::Peer> peer;
  protocol::Role role = protocol::Role::kPlay;
  /// The token it has sent; nullopt: the role is that of its transport, or of its user.
  std::optional<access::Token> token;
  /// Of the tokens and roles by which it got its role; 0: it was not admitted by a `TokenCheck`.
  std::uint64_t access_version = 0;
  /// Only `hello` with a token is executed: it needs one, its own was revoked, or its user has no
  /// role.
  bool locked = false;
  /// Ended by the daemon: no token unlocks it, and requests are rejected until its socket is
  /// closed.
  bool ended = false;
  std::string client;
  model::Tick since = 0;
  std::optional<TelemetrySubscription> telemetry;
  std::optional<EventSubscription> events;
  Sink* sink = nullptr;
  /// Its sink is flushed before the present `Server::pump` ends.
  bool flush_due = false;
  /// A batch is not executed further when its responses are longer.
  std::size_t batch_bytes = std::size_t{512} << 10;
  /// Size of responses that wait for others of their batch.
  std::size_t open_bytes = 0;
  /// Time at which the executing request was read, CLOCK_MONOTONIC ns; 0: unknown.
  std::int64_t received_ns = 0;
  /// Number of requests held until the client reads its responses.
  std::size_t held = 0;
  /// Number of them, from the first, that were sent before an executed emergency stop, or before
  /// the connection closed: they start nothing any more.
  std::size_t bypassed = 0;
};

}  // namespace hedgehog::server

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

using ConnectionId = std::int64_t;  // unique while the daemon runs; 0: none

/// kSoon: with other clients' lines, after the io thread's present work. kAtOnce: before long work.
enum class Flush : std::uint8_t { kSoon, kAtOnce };

/// Destination of a session's lines: a socket, or a list in tests.
class Sink {
 public:
  virtual ~Sink() = default;
  /// `line` has no LF. May end a session whose client does not read, but not within this call.
  virtual void send(std::string line, LineKind kind) = 0;
  /// The same for telemetry shared with other clients.
  virtual void send_telemetry(const SharedLine& line) {
    send(line->substr(0, line->size() - 1), LineKind::kTelemetry);
  }
  /// Writes the queue (`Server::flush_after_pump`); sends no line and ends no session within it.
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
  std::optional<access::Peer> peer;  // Unix socket only; nullopt: not provided by the system
  protocol::Role role = protocol::Role::kPlay;
  std::optional<access::Token> token;  // sent; nullopt: role of its transport or user
  std::uint64_t access_version = 0;    // of the TokenCheck that gave the role; 0: none
  /// Executes only `hello` with a token: it has none, a revoked one, or a user without a role.
  bool locked = false;
  /// Ended by the daemon: no token unlocks it; requests are rejected until its socket is closed.
  bool ended = false;
  std::string client;
  model::Tick since = 0;
  std::optional<TelemetrySubscription> telemetry;
  std::optional<EventSubscription> events;
  Sink* sink = nullptr;
  bool flush_due = false;  // its sink is flushed before Server::pump ends
  /// A batch is not executed further when its responses are longer.
  std::size_t batch_bytes = std::size_t{512} << 10;
  std::size_t open_bytes = 0;    // of responses that wait for others of their batch
  std::int64_t received_ns = 0;  // when the present request was read, CLOCK_MONOTONIC; 0: unknown
  /// Requests held until the client reads its responses; and one more between the end of its
  /// requests and that of its responses.
  std::size_t held = 0;
  /// Number of the first of them, sent before an emergency stop or the close: they start nothing.
  std::size_t bypassed = 0;
};

}  // namespace hedgehog::server

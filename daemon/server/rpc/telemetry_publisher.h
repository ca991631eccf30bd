// SPDX-License-Identifier: MIT
// Telemetry notifications to the sessions that subscribed. A tick is encoded once per list of
// fields, and the bytes are shared by all clients with that list.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "daemon/server/rpc/handler_context.h"
#include "daemon/server/session/session.h"
#include "model/tick.h"
#include "protocol/values/status.h"

namespace hedgehog::server {

/// io thread only.
class TelemetryPublisher {
 public:
  /// Maximum number of lines per `pump`, which bounds the delay of requests.
  static constexpr std::size_t kSlice = 64;
  static constexpr model::Tick kNever = model::Tick{1} << 60;

  explicit TelemetryPublisher(HandlerContext& context) : context_(context) {}

  /// Finds the sessions due at the latest tick, and sends to the first `kSlice` waiting ones. The
  /// data is always that of the latest tick.
  void pump();
  /// Some sessions have not been served by the last `pump`.
  bool has_unsent() const noexcept { return !due_.empty(); }
  /// Sends to `session` when it is due. REQUIRES: it has subscribed.
  void expect(Session& session);
  /// Ticks from now until the next session is due, at least 1; kNever without any.
  model::Tick due_in() const noexcept;

 private:
  /// A session at one of its ticks; void unless that is still its `next`.
  struct Due {
    ConnectionId id;
    model::Tick tick;
  };
  void find_due(model::Tick now);
  const SharedLine& line(protocol::StatusKeys fields);
  const protocol::Status& status(bool with_pins);

  HandlerContext& context_;
  /// In the order in which they became due.
  std::deque<Due> due_;
  /// By the tick at which they will be.
  std::map<model::Tick, std::vector<ConnectionId>> expected_{};
  model::Tick tick_ = -1;
  // Of `tick_`.
  std::array<std::optional<protocol::Status>, 2> status_;  // without and with pins
  std::vector<std::pair<protocol::StatusKeys, SharedLine>> lines_;
};

}  // namespace hedgehog::server

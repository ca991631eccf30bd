// SPDX-License-Identifier: MIT
// Telemetry to subscribed sessions, encoded once per tick and list of fields for all clients.
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
  static constexpr std::size_t kSlice = 64;  // lines per pump, to bound the delay of requests
  static constexpr model::Tick kNever = model::Tick{1} << 60;

  explicit TelemetryPublisher(HandlerContext& context) : context_(context) {}

  /// Sends the data of the latest tick to the first `kSlice` of the sessions that are due.
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
  std::deque<Due> due_;  // in the order in which they became due
  std::map<model::Tick, std::vector<ConnectionId>> expected_{};  // by their due tick
  model::Tick tick_ = -1;                                        // of status_ and lines_
  std::array<std::optional<protocol::Status>, 2> status_;        // without and with pins
  std::vector<std::pair<protocol::StatusKeys, SharedLine>> lines_;
};

}  // namespace hedgehog::server

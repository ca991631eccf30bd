// SPDX-License-Identifier: MIT
// Telemetry notifications to the sessions that subscribed. A tick is encoded once for each list of
// fields, and its bytes are shared by all who asked for that list.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
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
  /// Lines of one `pump`, so that requests wait no longer than it takes to send these.
  static constexpr std::size_t kSlice = 64;

  explicit TelemetryPublisher(HandlerContext& context) : context_(context) {}

  /// Finds who is due at the latest tick, and sends to the first `kSlice` of those that wait. What
  /// is sent is of the latest tick, also to those that have waited.
  void pump();
  /// Some wait that the last `pump` has left out.
  bool has_unsent() const noexcept { return !due_.empty(); }

 private:
  void find_due(model::Tick now);
  const SharedLine& line(protocol::StatusKeys fields);
  const protocol::Status& status(bool with_pins);

  HandlerContext& context_;
  /// In the order in which they became due.
  std::deque<ConnectionId> due_;
  model::Tick tick_ = -1;
  // Of `tick_`.
  std::array<std::optional<protocol::Status>, 2> status_;  // without and with pins
  std::vector<std::pair<protocol::StatusKeys, SharedLine>> lines_;
};

}  // namespace hedgehog::server

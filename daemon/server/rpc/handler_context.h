// SPDX-License-Identifier: MIT
// Dependencies of the handlers. One object, owned by the server.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "daemon/server/device/device_scanner.h"
#include "daemon/server/device/device_view.h"
#include "daemon/server/device/state_store.h"
#include "daemon/server/effects/effect_registry.h"
#include "daemon/server/effects/keyframe_allocator.h"
#include "daemon/server/effects/latency_log.h"
#include "daemon/server/effects/planning.h"
#include "daemon/server/history/telemetry_samples.h"
#include "daemon/server/rpc/view/status_view.h"
#include "daemon/server/session/claim.h"
#include "daemon/server/session/counters.h"
#include "daemon/server/session/session.h"
#include "daemon/server/session/start_id.h"
#include "daemon/server/session/token_check.h"
#include "protocol/methods.h"
#include "protocol/wire/error.h"

namespace hedgehog::server {

class EventHistory;
class PatternLibrary;
class Preview;
class TripRecordings;

struct HandlerContext {
  DeviceView& device_view;
  EffectRegistry& effects;
  KeyframeAllocator& keyframes;
  PatternLibrary& patterns;
  EventHistory& history;
  Claim& claim;
  StatusView& status;
  StateStore& state_store;
  std::map<ConnectionId, Session*> sessions{};
  ConnectionId orientation_feeder = 0;  // sets it with imu.type "external"; 0: none yet
  TokenCheck tokens{};
  Counters counters{};
  TelemetrySamples telemetry{};
  LatencyLog latency{};
  std::string start_id = random_start_id();
  DeviceScanner* devices = nullptr;      // nullptr: devices are not scanned
  TripRecordings* recordings = nullptr;  // nullptr: trips are not recorded
  /// Previews in progress, by connection; completed ones have expired.
  std::map<ConnectionId, std::weak_ptr<Preview>> previews{};
  /// The coils are off and the daemon is stopping: only pending responses are still sent.
  bool stopping = false;

  std::size_t max_connections = config::ConnectionSettings{}.max;

  bool has_previews() const noexcept;        // in progress
  std::size_t connections() const noexcept;  // sessions that are not locked
  /// See `Server::log_in` and `Server::check_token`; logged and counted.
  std::optional<protocol::RpcError> log_in(Session& session, std::string_view secret);
  std::optional<protocol::RpcError> check_token(Session& session, std::string_view secret);
};

/// One request in execution.
struct Call {
  HandlerContext& context;
  Session& session;
  /// False for a notification: work only needed for the response may be omitted.
  bool expects_response = true;

  DeviceView& device_view() const noexcept { return context.device_view; }
  PlanContext plan_context() const noexcept {
    return {context.device_view, context.patterns, session.role};
  }
};

using Response = protocol::Result<protocol::ResultValue>;

/// A response that depends on future ticks, polled after each. `give_up`: control does not run.
struct Deferred {
  std::function<std::optional<Response>(HandlerContext&, bool give_up)> poll;
};

/// A result that is already JSON.
struct Encoded {
  std::shared_ptr<const std::string> result;
};

/// A response whose computation must not delay the effect: it is completed once the commands of the
/// line have been passed on, within the same call and as of the same snapshot.
struct AfterCommit {
  std::function<Response()> complete;
};

using Outcome = std::variant<Response, Deferred, Encoded, AfterCommit>;

}  // namespace hedgehog::server

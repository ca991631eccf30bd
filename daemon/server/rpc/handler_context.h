// SPDX-License-Identifier: MIT
// Dependencies of the handlers. One object, made by the server.
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
#include "daemon/server/effects/effect_plan.h"
#include "daemon/server/effects/effect_registry.h"
#include "daemon/server/effects/keyframe_allocator.h"
#include "daemon/server/effects/latency_log.h"
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
  /// The connection that feeds the orientation when `imu.type` is `external`; 0: none yet.
  ConnectionId orientation_feeder = 0;
  TokenCheck tokens{};
  Counters counters{};
  TelemetrySamples telemetry{};
  LatencyLog latency{};
  /// Of this start of the daemon.
  std::string start_id = random_start_id();
  /// nullptr: devices are not scanned.
  DeviceScanner* devices = nullptr;
  /// nullptr: trips are not recorded.
  TripRecordings* recordings = nullptr;
  /// Being worked out now, by who asked; those that are done have expired.
  std::map<ConnectionId, std::weak_ptr<Preview>> previews{};
  /// The coils are off and the daemon stops: only pending responses are still sent.
  bool stopping = false;

  /// `connections.max`.
  std::size_t max_connections = config::ConnectionSettings{}.max;

  /// Sessions that are not `locked`.
  std::size_t connections() const noexcept;
  /// As `Server::log_in`; logged and counted.
  std::optional<protocol::RpcError> log_in(Session& session, std::string_view secret);
};

/// One request being carried out.
struct Call {
  HandlerContext& context;
  Session& session;
  /// Nobody reads the answer: what only it needs may be left out.
  bool answered = true;

  DeviceView& device_view() const noexcept { return context.device_view; }
  PlanContext plan_context() const noexcept {
    return {context.device_view, context.patterns, session.role};
  }
};

using Answer = protocol::Result<protocol::ResultValue>;

/// The answer depends on ticks to come; asked again after each until it has one. `give_up`: the
/// control thread does not run.
struct Deferred {
  std::function<std::optional<Answer>(HandlerContext&, bool give_up)> poll;
};

/// A result that is JSON already.
struct Encoded {
  std::shared_ptr<const std::string> result;
};

using Outcome = std::variant<Answer, Deferred, Encoded>;

}  // namespace hedgehog::server

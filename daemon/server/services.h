// SPDX-License-Identifier: MIT
// What handlers work with. Made by the server, one of each.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "daemon/server/claim.h"
#include "daemon/server/counters.h"
#include "daemon/server/device_looker.h"
#include "daemon/server/effect_registry.h"
#include "daemon/server/keyframe_room.h"
#include "daemon/server/machine.h"
#include "daemon/server/session.h"
#include "daemon/server/status_view.h"
#include "protocol/error.h"
#include "protocol/results.h"

namespace hedgehog::server {

/// What a restart must not forget. Called on the io thread; writes on the disk thread.
class Memory {
 public:
  virtual ~Memory() = default;
  /// The owner's gain, or a latch that the control thread has not confirmed yet.
  virtual void remember_gain(double gain) = 0;
  virtual void remember_latch(control::Reason latch) = 0;
};

class EventHistory;
class PatternLibrary;
class Preview;
class TripRecordings;

struct Services {
  Machine& machine;
  EffectRegistry& effects;
  KeyframeRoom& keyframes;
  PatternLibrary& patterns;
  EventHistory& history;
  Claim& claim;
  StatusView& status;
  Memory& memory;
  std::map<ConnectionId, Session*> sessions{};
  /// Who feeds the orientation when `imu.type` is `external`; 0: nobody yet.
  ConnectionId orientation_feeder = 0;
  Counters counters{};
  /// nullptr: nobody looks, and there is nothing to see.
  DeviceLooker* devices = nullptr;
  /// nullptr: trips are not recorded.
  TripRecordings* recordings = nullptr;
  /// Being worked out now, by who asked; those that are done have expired.
  std::map<ConnectionId, std::weak_ptr<Preview>> previews{};
  /// The coils are off and the daemon ends: only who is owed an answer still gets one.
  bool leaving = false;
};

/// One request being carried out.
struct Call {
  Services& services;
  Session& session;
  /// Nobody reads the answer: what only it needs may be left out.
  bool answered = true;

  Machine& machine() const noexcept { return services.machine; }
};

using Answer = protocol::Result<protocol::ResultValue>;

/// The answer depends on ticks to come; asked again after each until it has one. `give_up`: the
/// control thread does not run.
struct Deferred {
  std::function<std::optional<Answer>(Services&, bool give_up)> poll;
};

/// A result that is JSON already.
struct Encoded {
  std::shared_ptr<const std::string> result;
};

using Outcome = std::variant<Answer, Deferred, Encoded>;

}  // namespace hedgehog::server

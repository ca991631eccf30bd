// SPDX-License-Identifier: MIT
// The server without its sockets: sessions come and go, say lines, and hear answers, events and
// telemetry. Lives on the io thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/server/claim.h"
#include "daemon/server/dispatcher.h"
#include "daemon/server/effect_registry.h"
#include "daemon/server/keyframe_room.h"
#include "daemon/server/machine.h"
#include "daemon/server/polled_time.h"
#include "daemon/server/services.h"
#include "daemon/server/session.h"
#include "daemon/server/status_view.h"

namespace hedgehog::server {

class Server {
 public:
  /// Called for everything that the control thread reports, clients' events or not, after the
  /// clients were told. `effect`: nullptr for other events.
  using EventListener = std::function<void(const control::Event&, const Effect* effect)>;

  /// Milliseconds since 1970, for what is remembered.
  using WallClock = std::function<std::int64_t()>;

  Server(Machine& machine, Memory& memory, PatternLibrary& patterns, EventHistory& history,
         EventListener listener, WallClock wall_clock);

  /// Who looks for device.list; outlives the server.
  void set_devices(DeviceLooker& devices) noexcept { services_.devices = &devices; }

  /// Who records trips; outlives the server.
  void set_recordings(TripRecordings& recordings) noexcept { services_.recordings = &recordings; }

  /// A client has come. `session` and its sink stay until `close`.
  void open(Session& session);
  /// It says no more: its effects end at the next tick, but for those that may play out. Its sink
  /// hears `finish` once the answers that are owed have gone out, perhaps at once.
  void close(Session& session);
  /// Its sink is about to be gone; what it was owed is lost.
  void forget(const Session& session);
  void line(Session& session, std::string_view text);
  void line_too_long(Session& session) { dispatcher_.line_too_long(session); }

  /// Takes what the control thread has to say and passes it on.
  void pump();
  /// Answers are still to come.
  bool owes() const noexcept { return dispatcher_.waiting(); }
  /// Somebody waits for the next tick: pump again in a millisecond.
  bool busy() const noexcept;

  std::size_t connections() const noexcept { return services_.sessions.size(); }
  const Services& services() const noexcept { return services_; }
  Counters& counters() noexcept { return services_.counters; }
  protocol::Status status() { return status_.status(false); }
  /// Since the control thread was last seen to tick, as of the last pump.
  std::chrono::steady_clock::duration control_silent() const noexcept {
    return control_silent_.elapsed();
  }
  /// Tells everybody who listens to events.
  void say_shutting_down(std::string reason);
  Machine& machine() noexcept { return machine_; }

 private:
  void let_go();
  void take_events();
  void tell(const control::Event& event, const Effect* effect);
  void remember(const protocol::Event& view, const control::Event& event, const Effect* effect);
  void send_telemetry();

  Machine& machine_;
  EventListener listener_;
  WallClock wall_clock_;
  EffectRegistry effects_;
  KeyframeRoom keyframes_;
  Claim claim_;
  StatusView status_;
  Services services_;
  Dispatcher dispatcher_;
  std::vector<ConnectionId> leaving_;
  ConnectionId last_id_ = 0;
  model::Tick last_tick_ = 0;
  PolledTime control_silent_{PolledTime::Clock::now()};
};

}  // namespace hedgehog::server

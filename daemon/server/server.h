// SPDX-License-Identifier: MIT
// The server without its sockets: sessions come and go, say lines, and hear answers, events and
// telemetry. Lives on the io thread.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/server/claim.h"
#include "daemon/server/dispatcher.h"
#include "daemon/server/effect_registry.h"
#include "daemon/server/machine.h"
#include "daemon/server/services.h"
#include "daemon/server/session.h"
#include "daemon/server/status_view.h"

namespace hedgehog::server {

class Server {
 public:
  /// Called for everything that the control thread reports, clients' events or not, after the
  /// clients were told. `effect`: nullptr for other events.
  using EventListener = std::function<void(const control::Event&, const Effect* effect)>;

  Server(Machine& machine, Memory& memory, EventListener listener);

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
  /// Somebody waits for the next tick: pump again in a millisecond.
  bool busy() const noexcept;

  std::size_t connections() const noexcept { return services_.sessions.size(); }
  /// Tells everybody who listens to events.
  void say_shutting_down(std::string reason);
  Machine& machine() noexcept { return machine_; }

 private:
  void let_go();
  void take_events();
  void tell(const control::Event& event, const Effect* effect);
  void send_telemetry();

  Machine& machine_;
  EventListener listener_;
  EffectRegistry effects_;
  Claim claim_;
  StatusView status_;
  Services services_;
  Dispatcher dispatcher_;
  std::vector<ConnectionId> leaving_;
  ConnectionId last_id_ = 0;
};

}  // namespace hedgehog::server

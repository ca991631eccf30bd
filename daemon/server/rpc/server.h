// SPDX-License-Identifier: MIT
// The server without sockets: sessions, requests, responses, events and telemetry. io thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/server/device/device_view.h"
#include "daemon/server/effects/effect_registry.h"
#include "daemon/server/effects/keyframe_allocator.h"
#include "daemon/server/rpc/dispatcher.h"
#include "daemon/server/rpc/handler_context.h"
#include "daemon/server/rpc/telemetry_publisher.h"
#include "daemon/server/rpc/view/status_view.h"
#include "daemon/server/session/claim.h"
#include "daemon/server/session/polled_time.h"
#include "daemon/server/session/session.h"

namespace hedgehog::server {

class Server {
 public:
  /// Called for everything that the control thread reports, clients' events or not, after the
  /// clients were notified. `effect`: nullptr for other events.
  using EventListener = std::function<void(const control::Event&, const Effect* effect)>;

  /// Milliseconds since 1970, for what is remembered.
  using WallClock = std::function<std::int64_t()>;

  Server(DeviceView& device_view, StateStore& memory, PatternLibrary& patterns,
         EventHistory& history, EventListener listener, WallClock wall_clock);

  /// The scanner of device.list; outlives the server.
  void set_devices(DeviceScanner& devices) noexcept { context_.devices = &devices; }

  /// The recorder of trips; outlives the server.
  void set_recordings(TripRecordings& recordings) noexcept { context_.recordings = &recordings; }

  /// From the start on and at each reload. A connection whose token is no longer valid ends, and
  /// one of the Unix socket whose user has another role now; others without a token get the role
  /// that their transport has now.
  void set_access(const config::Config& config);
  /// As `TokenCheck::log_in`; a `locked` session also needs a place among `connections.max`: busy.
  std::optional<protocol::RpcError> log_in(Session& session, std::string_view secret) {
    return context_.log_in(session, secret);
  }
  const TokenCheck& tokens() const noexcept { return context_.tokens; }

  /// A client has connected. `session` and its sink stay until `close`.
  void open(Session& session);
  /// It says no more: its effects end at the next tick, but for those that may play out. Its sink
  /// hears `finish` once the answers that are owed have gone out, perhaps at once; with requests
  /// that are held it lives on: call again after the last of them.
  void close(Session& session);
  /// Its sink is about to be destroyed; pending responses are lost.
  void forget(const Session& session);
  void line(Session& session, std::string_view text);
  void line_too_long(Session& session) { dispatcher_.line_too_long(session); }
  /// Whether it must not wait behind others: one of its requests is an emergency stop.
  static bool has_emergency_stop(std::string_view text) {
    return Dispatcher::has_emergency_stop(text);
  }

  /// Publishes the control thread's events and snapshot.
  void pump();
  /// So many answers to `session` are still to come.
  std::size_t pending(const Session& session) const noexcept {
    return dispatcher_.pending(session.id);
  }
  /// Answers are still to come.
  bool has_pending() const noexcept { return dispatcher_.waiting(); }
  /// Somebody waits for the next tick: pump again in a millisecond.
  bool busy() const noexcept;
  /// Some telemetry was left out, so that requests are served in between: pump again at once.
  bool has_unsent_telemetry() const noexcept { return telemetry_.has_unsent(); }

  /// Without those that are `locked`.
  std::size_t connections() const noexcept { return context_.connections(); }
  const HandlerContext& context() const noexcept { return context_; }
  Counters& counters() noexcept { return context_.counters; }
  TelemetrySamples& telemetry() noexcept { return context_.telemetry; }
  /// Whether a trip's recording, "trip-0017.hhr", is on disk.
  bool has_recording(std::string_view file) const;
  /// What is asked until it gives the recording, nullptr so far; empty: it is gone. None: the disk
  /// is too slow. REQUIRES: `has_recording`.
  std::function<std::shared_ptr<const std::string>()> read_recording(std::string_view file) const;
  protocol::Status status() { return status_.status(false); }
  /// Since the control thread was last seen to tick, as of the last pump.
  std::chrono::steady_clock::duration control_silent() const noexcept {
    return control_silent_.elapsed();
  }
  /// Tells everybody who listens to events.
  void announce_shutdown(std::string reason);
  DeviceView& device_view() noexcept { return device_view_; }

 private:
  void release();
  void take_effect_times();
  void take_events();
  void notify(const control::Event& event, const Effect* effect);
  void remember(const protocol::Event& view, const control::Event& event, const Effect* effect);
  void keep_telemetry();

  DeviceView& device_view_;
  EventListener listener_;
  WallClock wall_clock_;
  EffectRegistry effects_;
  KeyframeAllocator keyframes_;
  Claim claim_;
  StatusView status_;
  HandlerContext context_;
  Dispatcher dispatcher_;
  TelemetryPublisher telemetry_;
  std::vector<ConnectionId> closing_;
  ConnectionId last_id_ = 0;
  model::Tick last_tick_ = 0;
  PolledTime control_silent_{PolledTime::Clock::now()};
};

}  // namespace hedgehog::server

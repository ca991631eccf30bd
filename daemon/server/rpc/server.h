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
  /// Gets every event of the control thread. `effect`: nullptr for other events. May take long, for
  /// example for the log, only for events not of an effect: the sinks are flushed before those.
  using EventListener = std::function<void(const control::Event&, const Effect* effect)>;

  using WallClock = std::function<std::int64_t()>;  // ms since 1970, for recorded events

  Server(DeviceView& device_view, StateStore& state_store, PatternLibrary& patterns,
         EventHistory& history, EventListener listener, WallClock wall_clock);

  /// Scanner of device.list and recorder of trips; they outlive the server.
  void set_devices(DeviceScanner& devices) noexcept { context_.devices = &devices; }
  void set_recordings(TripRecordings& recordings) noexcept { context_.recordings = &recordings; }

  /// At the start and each reload. Closes connections whose token is no longer valid, or whose Unix
  /// user has another role; others without a token get the present role of their transport.
  void set_access(const config::Config& config);
  /// See `TokenCheck::log_in`; `busy` if a `locked` session would exceed `connections.max`.
  std::optional<protocol::RpcError> log_in(Session& session, std::string_view secret) {
    return context_.log_in(session, secret);
  }
  /// The same for a single request, which is no client: no limit, and no line in the log if the
  /// token is valid.
  std::optional<protocol::RpcError> check_token(Session& session, std::string_view secret) {
    return context_.check_token(session, secret);
  }
  const TokenCheck& tokens() const noexcept { return context_.tokens; }

  /// A client has connected. `session` and its sink must stay valid until `close`. Closes it at
  /// once if its access was revoked since it was admitted.
  void open(Session& session);
  /// The client has closed: its effects end at the next tick, except those that finish on close.
  /// Its sink gets `finish` once the pending responses have been sent, possibly at once; with held
  /// requests it stays open: call again after the last of them.
  void close(Session& session);
  /// Its sink is about to be destroyed; pending responses are lost.
  void drop_responses(const Session& session);
  void line(Session& session, std::string_view text);
  void line_too_long(Session& session) { dispatcher_.line_too_long(session); }
  static bool has_emergency_stop(std::string_view text) {
    return Dispatcher::has_emergency_stop(text);
  }

  /// Publishes the control thread's events and snapshot.
  void pump();
  /// For a sink that was sent a line and has `unsent_bytes`. True: more lines come with this
  /// `pump`, which calls `Sink::flush` after the last of them. False: nothing to wait for, or
  /// enough for a write of its own.
  bool flush_after_pump(Session& session, std::size_t unsent_bytes);
  /// Number of pending responses to `session`.
  std::size_t pending(const Session& session) const noexcept {
    return dispatcher_.pending(session.id);
  }
  bool has_pending() const noexcept { return dispatcher_.waiting(); }
  /// Ticks until the next `pump` is due, unless events come earlier: the next one while a client
  /// waits for it, else that of the next telemetry, if any (see TelemetryPublisher::kNever).
  model::Tick pump_due_in() const noexcept;
  /// Telemetry is unsent, so that requests are served in between: pump again at once.
  bool has_unsent_telemetry() const noexcept { return telemetry_.has_unsent(); }

  /// Without those that are `locked`.
  std::size_t connections() const noexcept { return context_.connections(); }
  const HandlerContext& context() const noexcept { return context_; }
  Counters& counters() noexcept { return context_.counters; }
  TelemetrySamples& telemetry() noexcept { return context_.telemetry; }
  /// True if the recording of a trip, "trip-0017.hhr", is on disk.
  bool has_recording(std::string_view file) const;
  /// A function to be polled until it returns the recording instead of nullptr; empty: it was
  /// removed. Returns none if the disk is too slow. REQUIRES: `has_recording`.
  std::function<std::shared_ptr<const std::string>()> read_recording(std::string_view file) const;
  protocol::Status status() { return status_.status(false); }
  /// Time since the last observed tick of the control thread, as of the last pump.
  std::chrono::steady_clock::duration control_silent() const noexcept {
    return control_silent_.elapsed();
  }
  /// Notifies all clients that have subscribed to events.
  void announce_shutdown(std::string reason);
  DeviceView& device_view() noexcept { return device_view_; }

 private:
  void revoke(Session& session);
  void release();
  void flush_sinks(Flush when);
  void take_effect_times();
  void take_events();
  void notify(const control::Event& event, const Effect* effect);
  void record_event(const protocol::Event& view, const control::Event& event, const Effect* effect);
  void record_telemetry();

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
  std::vector<ConnectionId> flush_due_;
  bool collecting_ = false;
  ConnectionId last_id_ = 0;
  model::Tick last_tick_ = 0;
  PolledTime control_silent_{PolledTime::Clock::now()};
};

}  // namespace hedgehog::server

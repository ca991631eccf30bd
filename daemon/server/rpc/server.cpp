// SPDX-License-Identifier: MIT
#include "daemon/server/rpc/server.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "daemon/server/history/event_history.h"
#include "daemon/server/history/trip_recordings.h"
#include "daemon/server/rpc/known_counters.h"
#include "daemon/server/rpc/view/event_view.h"
#include "daemon/server/session/origin.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

bool matches(const EventSubscription& subscription, std::string_view type) {
  return subscription.types.empty() ||
         std::find(subscription.types.begin(), subscription.types.end(), type) !=
             subscription.types.end();
}

bool is_of_effect(const control::Event& event) {
  return event.type == control::EventType::kEffectStarted ||
         event.type == control::EventType::kEffectEnded;
}

}  // namespace

Server::Server(DeviceView& device_view, StateStore& state_store, PatternLibrary& patterns,
               EventHistory& history, EventListener listener, WallClock wall_clock)
    : device_view_(device_view),
      listener_(std::move(listener)),
      wall_clock_(std::move(wall_clock)),
      status_(device_view, effects_),
      context_{device_view, effects_, keyframes_, patterns, history, claim_, status_, state_store},
      dispatcher_(context_),
      telemetry_(context_) {
  context_.counters = known_counters();
}

void Server::set_access(const config::Config& config) {
  context_.tokens.set_tokens(config.access.tokens);
  context_.tokens.set_unix_roles(config.access.unix_roles, ::geteuid());
  context_.tokens.set_simulated(config.backend == config::Backend::kSimulator);
  context_.max_connections = config.connections.max;
  std::vector<Session*> revoked;
  for (const auto& [id, session] : context_.sessions)
    if (!context_.tokens.renew(*session)) revoked.push_back(session);
  for (Session* session : revoked) revoke(*session);
}

void Server::revoke(Session& session) {
  spdlog::warn("connection {} ends: {}", session.id,
               session.token ? "its token " + session.token->name + " is revoked"
                             : "the role of " + origin_text(session) + " has changed");
  Sink* sink = session.sink;
  session.locked = session.ended = true;
  close(session);
  sink->finish();
}

void Server::open(Session& session) {
  session.id = ++last_id_;
  session.since = device_view_.now().tick;
  context_.sessions.emplace(session.id, &session);
  // A reload during its handshake has not found it among the sessions.
  if (!context_.tokens.is_current(session) && !context_.tokens.renew(session)) revoke(session);
}

void Server::close(Session& session) {
  if (!context_.sessions.contains(session.id)) return;
  for (const Effect* effect : effects_.release_all(session.id)) {
    device_view_.mailbox().stops.request(effect->id, effect->place,
                                         control::EndReason::kDisconnected);
  }
  claim_.release(session.id);
  if (context_.orientation_feeder == session.id) context_.orientation_feeder = 0;
  session.telemetry.reset();
  session.events.reset();
  if (session.held > 0) return;
  if (std::find(closing_.begin(), closing_.end(), session.id) == closing_.end())
    closing_.push_back(session.id);
  release();
}

void Server::drop_responses(const Session& session) {
  context_.sessions.erase(session.id);
  std::erase(closing_, session.id);
}

void Server::release() {
  std::erase_if(
      closing_,
      [&](ConnectionId id) {
        if (dispatcher_.has_pending(id)) return false;
        const auto session = context_.sessions.find(id);
        Sink* sink = session->second->sink;
        context_.sessions.erase(session);
        sink->finish();
        return true;
      });
}

void Server::line(Session& session, std::string_view text) {
  // Responses are based on the present snapshot, not on that of the last pump.
  device_view_.refresh();
  device_view_.outbox().set_received(session.received_ns);
  const bool was_due = pump_due_in() == 1;
  dispatcher_.line(session, text);
  device_view_.outbox().set_received(0);
  if (session.telemetry && !session.telemetry->expected) telemetry_.expect(session);
  if (!was_due && pump_due_in() == 1) device_view_.mailbox().wake_io.raise();
}

void Server::pump() {
  collecting_ = true;
  device_view_.refresh();
  const auto now = PolledTime::Clock::now();
  control_silent_.poll(now);
  if (device_view_.now().tick != last_tick_) {
    last_tick_ = device_view_.now().tick;
    control_silent_.restart(now);
  }
  keyframes_.applied(device_view_.now().applied_seq);
  take_effect_times();
  take_events();
  device_view_.outbox().flush();
  // Nothing waits for the slices of previews, which take up to 2 ms.
  if (context_.has_previews()) {
    flush_sinks(Flush::kAtOnce);
    collecting_ = false;
  }
  dispatcher_.poll();
  release();
  telemetry_.pump();
  collecting_ = false;
  flush_sinks(Flush::kSoon);
  record_telemetry();
  context_.history.pump(wall_clock_());
}

bool Server::flush_after_pump(Session& session, std::size_t unsent_bytes) {
  if (!collecting_ || unsent_bytes >= WriteQueue::kChunkBytes) return false;
  if (!std::exchange(session.flush_due, true)) flush_due_.push_back(session.id);
  return true;
}

void Server::flush_sinks(Flush when) {
  for (const ConnectionId id : flush_due_) {
    const auto session = context_.sessions.find(id);
    if (session == context_.sessions.end()) continue;
    session->second->flush_due = false;
    session->second->sink->flush(when);
  }
  flush_due_.clear();
}

model::Tick Server::pump_due_in() const noexcept {
  return dispatcher_.waiting() || device_view_.outbox().waiting() ? 1 : telemetry_.due_in();
}

void Server::take_effect_times() {
  control::EffectTimes times;
  while (device_view_.mailbox().effect_times.pop(times)) context_.latency.add(times);
}

void Server::take_events() {
  control::Event event;
  while (device_view_.mailbox().events.pop(event)) {
    if (event.type == control::EventType::kEffectEnded) {
      const std::optional<Effect> effect = effects_.ended(event.place, event.effect);
      if (effect)
        ++counters()
              .effects[{protocol::name(effect->plan.spec.method), control::name(event.end_reason)}];
      if (effect && effect->plan.track)
        keyframes_.release(effect->plan.spec.trajectory.playback.first);
      notify(event, effect ? &*effect : nullptr);
    } else if (event.type == control::EventType::kEffectStarted) {
      effects_.begun(event.place, event.effect);
      notify(event, effects_.at(event.place, event.effect));
    } else {
      if (event.trip) ++counters().trips[control::name(event.reason)];
      notify(event, nullptr);
    }
  }
}

void Server::notify(const control::Event& event, const Effect* effect) {
  auto view = event_view(event, effect, device_view_.epoch_ns(), device_view_.remedy_facts());
  if (view) {
    if (view->limit_a) view->limit_a = device_view_.shown_limit_a(*view->limit_a);
    const bool of_effect = view->effect.has_value();
    std::string line;
    for (const auto& [id, session] : context_.sessions) {
      const bool foreign = of_effect && (effect == nullptr || effect->owner != id);
      if (!session->events || !matches(*session->events, view->type) ||
          (foreign && session->events->scope == protocol::Scope::kMine))
        continue;
      if (line.empty()) line = protocol::encode_event(*view);
      session->sink->send(line, LineKind::kEvent);
    }
  }
  // See EventListener.
  if (!is_of_effect(event)) flush_sinks(Flush::kAtOnce);
  if (listener_) listener_(event, effect);
  // After the listener, which persists a latch first.
  if (view) record_event(*view, event, effect);
}

void Server::record_event(const protocol::Event& view, const control::Event& event,
                          const Effect* effect) {
  TripRecordings* recordings = context_.recordings;
  const unsigned recording = recordings != nullptr && event.trip ? recordings->tripped() : 0;
  context_.history.record(view, wall_clock_(), effect, recording);
}

bool Server::has_recording(std::string_view file) const {
  const unsigned number = recording_number_of_file(file);
  return number != 0 && context_.recordings != nullptr && context_.recordings->has(number);
}

std::function<std::shared_ptr<const std::string>()> Server::read_recording(
    std::string_view file) const {
  auto reading = context_.recordings->read(recording_number_of_file(file));
  if (!reading) return {};
  return [reading]() -> std::shared_ptr<const std::string> {
    if (!reading->done.load(std::memory_order_acquire)) return nullptr;
    return {reading, &reading->bytes};
  };
}

void Server::record_telemetry() {
  const control::StatusSnapshot& now = device_view_.now();
  context_.telemetry.watch(now);
  if (context_.telemetry.due(now.tick)) context_.telemetry.add(now, status_.status(false));
}

void Server::announce_shutdown(std::string reason) {
  context_.stopping = true;
  protocol::Event event;
  event.type = "shutting_down";
  event.time_ns = device_view_.time_ns(device_view_.now().tick);
  event.reason = std::move(reason);
  context_.history.record(event, wall_clock_(), nullptr);
  const std::string line = protocol::encode_event(event);
  for (const auto& [id, session] : context_.sessions)
    if (session->events && matches(*session->events, event.type))
      session->sink->send(line, LineKind::kEvent);
}

}  // namespace hedgehog::server

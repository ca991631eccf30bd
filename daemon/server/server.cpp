// SPDX-License-Identifier: MIT
#include "daemon/server/server.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "daemon/server/event_history.h"
#include "daemon/server/event_view.h"
#include "daemon/server/trip_recordings.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

bool wants(const EventSubscription& subscription, std::string_view type) {
  return subscription.types.empty() ||
         std::find(subscription.types.begin(), subscription.types.end(), type) !=
             subscription.types.end();
}

}  // namespace

Server::Server(Machine& machine, Memory& memory, PatternLibrary& patterns, EventHistory& history,
               EventListener listener, WallClock wall_clock)
    : machine_(machine),
      listener_(std::move(listener)),
      wall_clock_(std::move(wall_clock)),
      status_(machine, effects_),
      services_{machine, effects_, keyframes_, patterns, history, claim_, status_, memory},
      dispatcher_(services_) {}

void Server::open(Session& session) {
  session.id = ++last_id_;
  session.since = machine_.now().tick;
  services_.sessions.emplace(session.id, &session);
}

void Server::close(Session& session) {
  if (!services_.sessions.contains(session.id)) {
    return;
  }
  for (const Effect* effect : effects_.disown(session.id)) {
    machine_.mailbox().stops.request(effect->id, effect->place, control::EndReason::kDisconnected);
  }
  claim_.release(session.id);
  if (services_.orientation_feeder == session.id) {
    services_.orientation_feeder = 0;
  }
  session.telemetry.reset();
  session.events.reset();
  leaving_.push_back(session.id);
  let_go();
}

void Server::forget(const Session& session) {
  services_.sessions.erase(session.id);
  std::erase(leaving_, session.id);
}

void Server::let_go() {
  std::erase_if(leaving_, [&](ConnectionId id) {
    if (dispatcher_.owes(id)) {
      return false;
    }
    const auto session = services_.sessions.find(id);
    Sink* sink = session->second->sink;
    services_.sessions.erase(session);
    sink->finish();
    return true;
  });
}

void Server::line(Session& session, std::string_view text) {
  // What a client hears is of now, not of the last pump.
  machine_.refresh();
  dispatcher_.line(session, text);
}

void Server::pump() {
  machine_.refresh();
  const auto now = PolledTime::Clock::now();
  control_silent_.poll(now);
  if (machine_.now().tick != last_tick_) {
    last_tick_ = machine_.now().tick;
    control_silent_.restart(now);
  }
  keyframes_.applied(machine_.now().applied_seq);
  take_events();
  machine_.outbox().flush();
  dispatcher_.poll();
  let_go();
  send_telemetry();
  services_.history.pump(wall_clock_());
}

bool Server::busy() const noexcept {
  return dispatcher_.waiting() || machine_.outbox().waiting() ||
         std::any_of(services_.sessions.begin(), services_.sessions.end(), [](const auto& entry) {
           return entry.second->telemetry || entry.second->events;
         });
}

void Server::take_events() {
  control::Event event;
  while (machine_.mailbox().events.pop(event)) {
    if (event.type == control::EventType::kEffectEnded) {
      const std::optional<Effect> effect = effects_.ended(event.place, event.effect);
      if (effect) {
        ++counters().effects[{protocol::name(effect->method), control::name(event.end_reason)}];
      }
      if (effect && effect->score) {
        keyframes_.let_go(effect->spec.trajectory.score.first);
      }
      tell(event, effect ? &*effect : nullptr);
    } else if (event.type == control::EventType::kEffectStarted) {
      effects_.begun(event.place, event.effect);
      tell(event, effects_.at(event.place, event.effect));
    } else {
      if (event.trip) {
        ++counters().trips[control::name(event.reason)];
      }
      tell(event, nullptr);
    }
  }
}

void Server::tell(const control::Event& event, const Effect* effect) {
  const auto view = event_view(event, effect, machine_.epoch_ns(), machine_.remedy_facts());
  if (view) {
    const bool of_effect = view->effect.has_value();
    std::string line;
    for (const auto& [id, session] : services_.sessions) {
      const bool foreign = of_effect && (effect == nullptr || effect->owner != id);
      if (!session->events || !wants(*session->events, view->type) ||
          (foreign && session->events->scope == protocol::Scope::kMine)) {
        continue;
      }
      if (line.empty()) {
        line = protocol::encode_event(*view);
      }
      session->sink->send(line, LineKind::kEvent);
    }
  }
  if (listener_) {
    listener_(event, effect);
  }
  // After the listener, who makes a latch safe first.
  if (view) {
    remember(*view, event, effect);
  }
}

void Server::remember(const protocol::Event& view, const control::Event& event,
                      const Effect* effect) {
  TripRecordings* recordings = services_.recordings;
  const unsigned recording = recordings != nullptr && event.trip ? recordings->tripped() : 0;
  services_.history.record(view, wall_clock_(), effect, recording);
}

void Server::send_telemetry() {
  const model::Tick now = machine_.now().tick;
  std::vector<Session*> due;
  bool with_pins = false;
  for (const auto& [id, session] : services_.sessions) {
    if (session->telemetry && session->telemetry->next <= now) {
      due.push_back(session);
      with_pins = with_pins || session->telemetry->fields.contains(protocol::StatusKey::kPins);
    }
  }
  if (due.empty()) {
    return;
  }
  protocol::Telemetry telemetry;
  telemetry.status = status_.status(with_pins);
  for (Session* session : due) {
    TelemetrySubscription& wanted = *session->telemetry;
    wanted.next += wanted.period;
    if (wanted.next <= now) {
      wanted.next = now + wanted.period;
    }
    telemetry.keys = wanted.fields;
    session->sink->send(protocol::encode_telemetry(telemetry), LineKind::kTelemetry);
  }
}

void Server::say_shutting_down(std::string reason) {
  services_.leaving = true;
  protocol::Event event;
  event.type = "shutting_down";
  event.time_ns = machine_.time_ns(machine_.now().tick);
  event.reason = std::move(reason);
  services_.history.record(event, wall_clock_(), nullptr);
  const std::string line = protocol::encode_event(event);
  for (const auto& [id, session] : services_.sessions) {
    if (session->events && wants(*session->events, event.type)) {
      session->sink->send(line, LineKind::kEvent);
    }
  }
}

}  // namespace hedgehog::server

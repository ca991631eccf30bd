// SPDX-License-Identifier: MIT
#include "clients/orientation/indicator.h"

#include <algorithm>

namespace hedgehog::client {

namespace {

using protocol::EffectParams;
using std::chrono::milliseconds;

constexpr const char* kSlot = "orientation";
constexpr std::int64_t kLeaseMs = 500;
constexpr milliseconds kReportEvery{1000};
constexpr double kFollowHz = 100.0;
constexpr double kReportHz = 10.0;
// A daemon that shuts down first ends the effects and then reports the shutdown.
constexpr milliseconds kShutdownTimeout{1000};
// Same age limit as of the daemon's world-frame effects.
constexpr std::int64_t kStaleMs = 100;

protocol::EffectStart effect_of(Style style) {
  EffectParams params;
  params.slot = kSlot;
  params.direction = protocol::Word::kUp;
  params.lease_ms = kLeaseMs;
  if (style == Style::kSteady) {
    params.current_a = 5.0;
    return {model::EffectMethod::kHold, params};
  }
  params.waveform = model::Waveform::kSquare;
  params.frequency_hz = 2.0;
  params.on_fraction = 0.15;
  params.current_a = 12.0;
  return {model::EffectMethod::kVibrate, params};
}

protocol::StatusKeys followed_keys() {
  protocol::StatusKeys keys;
  for (const auto key : {protocol::StatusKey::kOrientation, protocol::StatusKey::kPin,
                         protocol::StatusKey::kForceN, protocol::StatusKey::kTemperatureC})
    keys.add(key);
  return keys;
}

}  // namespace

Indicator::Indicator(Connection& connection, const IndicatorOptions& options)
    : connection_(connection), options_(options) {}

Outcome<void> Indicator::run(const std::function<bool()>& stop,
                             const std::function<void(const IndicatorReport&)>& report) {
  if (auto started = start(); !started) return started;
  while (!stop()) {
    if (options_.duration && Clock::now() - started_at_ >= *options_.duration) break;
    auto notification = connection_.next(milliseconds{50});
    if (!notification) return notification.error();
    if (*notification) {
      if (auto taken = take(**notification, report); !taken) return taken;
    }
    if (auto ended = check_ended(); !ended) return ended;
  }
  const auto stopped = connection_.call(protocol::EffectStopAll{});
  return stopped ? Outcome<void>() : Outcome<void>(stopped.error());
}

Outcome<void> Indicator::start() {
  const protocol::EventsSubscribe ends{{"effect_ended", "shutting_down"}};
  if (auto events = connection_.call(ends); !events) return events.error();
  if (auto played = play({}); !played) return played;
  const double rate_hz = options_.loop == Loop::kClient ? kFollowHz : kReportHz;
  if (auto telemetry = connection_.call(protocol::TelemetrySubscribe{rate_hz, followed_keys()});
      !telemetry)
    return telemetry.error();
  started_at_ = Clock::now();
  return {};
}

Outcome<void> Indicator::play(const std::optional<model::Vec3>& direction) {
  protocol::EffectStart effect = effect_of(options_.style);
  if (direction) effect.params.direction = *direction;
  if (options_.loop == Loop::kDaemon) effect.params.frame = model::Frame::kWorld;
  const auto admitted = connection_.call(effect);
  if (!admitted) return admitted.error();
  effect_ = admitted->effect;
  lapsed_ = false;
  return {};
}

Outcome<void> Indicator::take(const Notification& notification,
                              const std::function<void(const IndicatorReport&)>& report) {
  if (const auto* event = std::get_if<protocol::EventMessage>(&notification)) {
    take(event->event);
    return {};
  }
  const auto* message = std::get_if<protocol::TelemetryMessage>(&notification);
  const protocol::Status& status = message->telemetry.status;
  if (Clock::now() - reported_ >= kReportEvery) {
    reported_ = Clock::now();
    IndicatorReport now;
    if (status.orientation && status.orientation->age_ms <= kStaleMs)
      now.up = status.orientation->up;
    now.pin = status.pin;
    now.force_n = status.force_n;
    now.temperature_c = status.temperature_c.model;
    report(now);
  }
  if (ended_ || shutting_down_) return {};
  return options_.loop == Loop::kClient ? follow(status) : renew();
}

void Indicator::take(const protocol::Event& event) {
  shutting_down_ = shutting_down_ || event.type == "shutting_down";
  if (event.type != "effect_ended" || event.effect != effect_) return;
  // The lease expired: the orientation was unknown, or this program was delayed. It resumes later.
  if (event.reason == "expired" || event.reason == "orientation_lost") {
    lapsed_ = true;
  } else {
    ended_ = event.reason.value_or("");
    ended_at_ = Clock::now();
  }
}

Outcome<void> Indicator::check_ended() const {
  if (!ended_ || shutting_down_ || Clock::now() - ended_at_ < kShutdownTimeout) return {};
  return ClientError{Failure::kRefused, "the effect was ended: " + *ended_, {}};
}

Outcome<void> Indicator::follow(const protocol::Status& status) {
  if (!status.orientation || status.orientation->age_ms > kStaleMs) {
    // Not renewed either: without a known orientation the effect ends by its lease.
    return {};
  }
  if (lapsed_) return play(status.orientation->up);
  EffectParams params;
  params.slot = kSlot;
  params.direction = status.orientation->up;
  return connection_.notify(protocol::EffectUpdate{std::nullopt, params});
}

Outcome<void> Indicator::renew() {
  if (lapsed_) return play({});
  EffectParams params;
  params.slot = kSlot;
  return connection_.notify(protocol::EffectUpdate{std::nullopt, params});
}

}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
#include "clients/study/session/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "model/vec3.h"

namespace hedgehog::study {

namespace {

using client::Milliseconds;
using client::Outcome;

constexpr std::int64_t kNsPerMs = 1'000'000;
// The claim lasts ten seconds of device time and is renewed after two.
constexpr std::int64_t kRenewNs = 2'000 * kNsPerMs;
// In device time; also the period at which claims can be renewed.
constexpr double kTelemetryHz = 5.0;
// Before the first interval, so that the hand can settle.
constexpr std::int64_t kLeadMs = 500;
constexpr Milliseconds kMessagePoll{5};
constexpr double kFullStrength = 0.98;
// After this time an effect must have ended, whether or not the daemon reported it.
constexpr std::int64_t kOverdueNs = 5'000 * kNsPerMs;
// One or two ticks at either end.
constexpr std::int64_t kShortMs = 3;
constexpr double kRounding = 1e-9;

protocol::EffectStart circle(const Stimulus& stimulus, const Pattern& pattern) {
  protocol::EffectParams params;
  params.current_a = stimulus.current_a;
  params.speed_pins_s = stimulus.speed_pins_s;
  params.ring_deg = pattern.ring_deg;
  params.sense =
      pattern.clockwise ? protocol::Sense::kClockwise : protocol::Sense::kCounterClockwise;
  params.duration_ms = pattern.duration_ms;
  return {model::EffectMethod::kCircle, params};
}

std::string degrees(double celsius) { return fmt::format("{:.1f} °C", celsius); }

}  // namespace

std::optional<std::string> fault_of(const IntervalPlayed& played, const Pattern& pattern) {
  const std::string which = "interval " + std::to_string(played.interval);
  if (played.reason != "completed") return which + " ended as " + played.reason;
  if (!played.onset_ns || !played.offset_ns) return which + " never began";
  if (*played.offset_ns - *played.onset_ns < (pattern.duration_ms - kShortMs) * kNsPerMs)
    return which + " was cut short";
  if (!played.delivered_min || !played.masked_ms || !played.mixed_ms)
    return which + " ended without a delivery report";
  if (*played.delivered_min < kFullStrength) {
    return which + " was delivered at " +
           std::to_string(static_cast<int>(100.0 * *played.delivered_min)) + " %";
  }
  if (*played.masked_ms > 0) return which + " was masked by another effect";
  if (*played.mixed_ms > 0) return which + " was mixed with another effect";
  return std::nullopt;
}

std::optional<std::string> beyond(const Experiment& experiment, double max_a) {
  const bool two = experiment.task == Task::kTwoIntervals;
  const double reference_a = two ? reference_stimulus(experiment).current_a : 0.0;
  const double highest_a = test_stimulus(experiment, experiment.rule.ceiling).current_a;
  if (std::max(reference_a, highest_a) <= max_a + kRounding) return std::nullopt;
  return fmt::format(
      "{} goes up to {:.3g} A and this ball plays at most {:.3g} A: copy the experiment's file "
      "and lower its {}",
      experiment.name, std::max(reference_a, highest_a), max_a,
      highest_a > max_a + kRounding ? "ceiling" : "current_a");
}

std::optional<std::string> Player::too_much(const Experiment& experiment) const {
  return beyond(experiment, max_a_);
}

Outcome<Player> Player::open(const std::vector<client::Address>& addresses, Milliseconds timeout,
                             Milliseconds silence) {
  auto connection = client::Connection::reopen(addresses, timeout);
  if (!connection) return connection.error();
  Player player(*std::move(connection), silence);
  if (auto introduced = player.introduce(); !introduced) return introduced.error();
  return player;
}

Outcome<void> Player::introduce() {
  const auto hello = connection_.hello("hedgehog-study/" HEDGEHOG_VERSION);
  if (!hello) return hello.error();
  const auto description = connection_.call(protocol::DeviceDescribe{});
  if (!description) return description.error();
  pin_.ball = {description->name, description->model, description->board.serial,
               description->simulated, description->calibration.force_n_per_a};
  pin_.daemon = {client::to_string(connection_.address()), hello->start_id};
  max_a_ = description->limits.current_a;
  if (auto notification = connection_.call(protocol::EventsSubscribe{{"effect_ended"}});
      !notification)
    return notification.error();
  protocol::StatusKeys keys;
  for (const auto key : {protocol::StatusKey::kTimeNs, protocol::StatusKey::kTemperatureC,
                         protocol::StatusKey::kCurrentA, protocol::StatusKey::kOrientation})
    keys.add(key);
  if (auto notification = connection_.call(protocol::TelemetrySubscribe{kTelemetryHz, keys});
      !notification)
    return notification.error();
  const auto now = clock_ns();
  if (!now) return now.error();
  device_ns_ = *now;
  return claim();
}

Outcome<std::int64_t> Player::clock_ns() {
  const auto pong = connection_.call(protocol::Ping{});
  if (!pong) return pong.error();
  return pong->time_ns;
}

Outcome<void> Player::claim() {
  const auto claimed = connection_.call(protocol::DeviceClaim{protocol::kMaxLeaseMs});
  if (!claimed) return claimed.error();
  claimed_ns_ = device_ns_;
  return {};
}

void Player::take(const client::Notification& notification) {
  received_ = std::chrono::steady_clock::now();
  if (const auto* event = std::get_if<protocol::EventMessage>(&notification)) {
    if (event->event.type == "effect_ended" && event->event.effect == effect_)
      ended_ = event->event;
    return;
  }
  const protocol::Status& status =
      std::get<protocol::TelemetryMessage>(notification).telemetry.status;
  device_ns_ = status.time_ns;
  temperature_c_ = status.temperature_c.model;
  orientation_.reset();
  if (status.orientation) orientation_ = status.orientation->quaternion;
  highest_a_ = std::max(highest_a_, model::norm(status.current_a));
}

Outcome<void> Player::keep(Milliseconds wait) {
  for (bool first = true;; first = false) {
    const auto notification = connection_.next(first ? wait : Milliseconds{0});
    if (!notification) return notification.error();
    if (!*notification) break;
    take(**notification);
  }
  if (std::chrono::steady_clock::now() - received_ > silence_)
    return client::ClientError{client::Failure::kTimeout, "no telemetry from the daemon", {}};
  return device_ns_ - claimed_ns_ >= kRenewNs ? claim() : Outcome<void>();
}

Outcome<IntervalPlayed> Player::play(int interval, const Stimulus& stimulus, const Pattern& pattern,
                                     std::optional<std::int64_t> not_before_ns,
                                     const std::function<bool()>& abort) {
  IntervalPlayed played;
  played.interval = interval;
  played.stimulus = stimulus;
  if (auto kept = keep(Milliseconds{0}); !kept) return kept.error();
  protocol::EffectStart start = circle(stimulus, pattern);
  const auto command = clock_ns();
  if (!command) return command.error();
  if (not_before_ns)
    start.params.start_at_ns = *not_before_ns;
  else
    start.params.delay_ms = kLeadMs;
  highest_a_ = 0.0;
  ended_.reset();
  const auto admitted = connection_.call(start);
  if (!admitted) return admitted.error();
  effect_ = admitted->effect;
  const auto ack = clock_ns();
  if (!ack) return ack.error();
  played.command_ns = *command;
  played.ack_ns = *ack;
  const std::int64_t overdue_ns = std::max(*ack + kLeadMs * kNsPerMs, not_before_ns.value_or(0)) +
                                  pattern.duration_ms * kNsPerMs + kOverdueNs;
  std::optional<std::chrono::steady_clock::time_point> stopped_at;
  while (!ended_) {
    if (auto kept = keep(kMessagePoll); !kept) return kept.error();
    const auto now = std::chrono::steady_clock::now();
    if (!ended_ && (device_ns_ > overdue_ns || (stopped_at && now - *stopped_at > max_silence()))) {
      return client::ClientError{
          client::Failure::kProtocol, "no effect_ended event was received for the circle", {}};
    }
    if (!stopped_at && !ended_ && abort()) {
      stopped_at = now;
      if (auto stopped = connection_.notify(protocol::EffectStop{effect_, std::nullopt}); !stopped)
        return stopped.error();
    }
  }
  played.onset_ns = ended_->onset_ns;
  played.offset_ns = ended_->offset_ns;
  played.reason = ended_->reason.value_or("");
  if (ended_->delivered) {
    played.delivered_min = ended_->delivered->min;
    played.delivered_mean = ended_->delivered->mean;
  }
  played.masked_ms = ended_->masked_ms;
  played.mixed_ms = ended_->mixed_ms;
  played.measured_a = highest_a_;
  played.temperature_c = temperature_c_;
  played.orientation = orientation_;
  return played;
}

Outcome<Readiness> Player::readiness(const Experiment& experiment, const Trial& trial) {
  const auto status = connection_.call(protocol::DeviceStatus{});
  if (!status) return status.error();
  if (status->state != "armed") {
    return Readiness{false, "the ball is " + status->state + " (" + status->reason.value_or("") +
                                "): " + status->remedy.value_or("")};
  }
  const std::string warm = status->temperature_c.model ? degrees(*status->temperature_c.model)
                                                       : std::string("no temperature");
  if (status->derating) return Readiness{false, "the ball is derating at " + warm, status->time_ns};
  // As if the stronger of the two intervals lasted for the whole trial.
  const Pattern& pattern = experiment.pattern;
  Stimulus strongest = trial.kind == TrialKind::kCatch ? Stimulus{0.0, pattern.speed_pins_s}
                                                       : test_stimulus(experiment, trial.level);
  double seconds = static_cast<double>(pattern.duration_ms) / 1000.0;
  if (experiment.task == Task::kTwoIntervals) {
    strongest.current_a = std::max(strongest.current_a, pattern.current_a);
    seconds *= 2.0;
  }
  protocol::ThermalForecast ask;
  ask.start = circle(strongest, pattern);
  const auto forecast = connection_.call(ask);
  if (!forecast) return forecast.error();
  if (forecast->seconds_to_derating && *forecast->seconds_to_derating < seconds) {
    return Readiness{false,
                     fmt::format("at {} {:.1f} A would be reduced after {:.0f} s: cooling down",
                                 warm, strongest.current_a, *forecast->seconds_to_derating),
                     status->time_ns};
  }
  return Readiness{true, warm + ", next trial at full strength"};
}

}  // namespace hedgehog::study

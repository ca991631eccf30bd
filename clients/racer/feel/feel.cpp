// SPDX-License-Identifier: MIT
#include "clients/racer/feel/feel.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace hedgehog::racer {

namespace {

using model::EffectMethod;
using protocol::EffectParams;
using protocol::EffectStart;
using protocol::ErrorCode;

// When the orientation of the ball is outdated, the car must not continue with the last one.
constexpr std::int64_t kStaleMs = 100;
// Lease of effects that are updated every frame.
constexpr std::int64_t kLeaseMs = 150;
constexpr std::int64_t kHitMs = 180;
constexpr std::int64_t kLandingMs = 140;
// Priorities: a blow masks the others; the tumble masks the skid.
constexpr std::int64_t kImpactPriority = 7;
constexpr std::int64_t kTumble = 6;
constexpr std::int64_t kSkid = 5;
// Relative to full strength: a lasting effect is weaker than the strongest blow.
constexpr double kTumbleStrength = 0.4;

/// Why a refusal is permanent for this game; empty: it is temporary.
std::string refusal_reason(const protocol::RpcError& error) {
  switch (error.code) {
    case ErrorCode::kClaimed:
      return "another client has exclusive use of the ball";
    case ErrorCode::kForbidden:
    case ErrorCode::kUnauthorized:
      return "the daemon grants this game the role observe only";
    default:
      return {};
  }
}

}  // namespace

void Feel::frame(const std::vector<RaceEvent>& race_events, double time_s) {
  time_s_ = time_s;
  played_.clear();
  listen();
  for (const RaceEvent& race_event : race_events)
    std::visit([this](const auto& what) { play(what); }, race_event);
}

/// On the side of the car that was hit.
void Feel::play(const Hit& hit) { play_impact("hit", hit.direction, hit.impulse_n_s, kHitMs); }

/// From below.
void Feel::play(const Landing& landing) {
  play_impact("landing", {0, 0, -1}, landing.impulse_n_s, kLandingMs);
}

void Feel::play_impact(const char* kind, const model::Vec3& direction, double impulse_n_s,
                       std::int64_t duration_ms) {
  const int step = step_of(impulse_n_s);
  if (!gate_.passes(step, time_s_)) {
    ++summary_.left_out;
    return;
  }
  EffectParams pulse;
  pulse.direction = direction;
  pulse.current_a = strength_of(step, limits().felt_a, full_a());
  pulse.duration_ms = duration_ms;
  pulse.priority = kImpactPriority;
  if (auto sent = play(kind, direction, {EffectMethod::kPulse, pulse}))
    pending_hits_.push_back(*std::move(sent));
  else
    ++summary_.refused;
}

/// A square wave downwards (thesis, section 4.1), stronger with less grip.
void Feel::play(const Skid& skid) {
  EffectParams buzz;
  buzz.slot = "skid";
  buzz.direction = protocol::Word::kDown;
  buzz.waveform = model::Waveform::kSquare;
  buzz.frequency_hz = 60.0;
  buzz.current_a = skid_strength(skid.amount, limits().felt_a, full_a());
  buzz.lease_ms = kLeaseMs;
  buzz.priority = kSkid;
  play("skid", {0, 0, -1}, {EffectMethod::kVibrate, buzz});
}

/// The direction of the ground moves round the ball as the car turns over.
void Feel::play(const Tumble& tumble) {
  EffectParams ground;
  ground.slot = "tumble";
  ground.direction = tumble.down;
  ground.current_a = std::max(limits().felt_a, kTumbleStrength * full_a());
  ground.lease_ms = kLeaseMs;
  ground.priority = kTumble;
  play("tumble", tumble.down, {EffectMethod::kHold, ground});
}

std::optional<protocol::Id> Feel::play(const char* kind, const model::Vec3& direction,
                                       EffectStart effect) {
  // A ball may be limited to less than the perception threshold.
  const double max_a = limits().current_a;
  const double current_a = std::min(effect.params.current_a.value_or(0.0), max_a);
  effect.params.current_a = current_a;
  // Requested even if the last one was refused, to detect when the game may play again.
  auto sent = request(effect);
  played_.push_back({kind, direction, current_a, max_a, sent && refused_.empty()});
  return sent;
}

void Feel::pause() { link_.notify(protocol::EffectStopAll{}); }

std::optional<protocol::Id> Feel::request(const protocol::Request& request) {
  return ball_.state == "armed" ? link_.request(request) : std::nullopt;
}

void Feel::listen() {
  const BallLink::Received received = link_.listen();
  if (received.arrived) {
    received_ns_ = 0;
    refused_.clear();
    if (link_.hello().role == protocol::Role::kObserve)
      refused_ = refusal_reason({.code = ErrorCode::kForbidden, .message = {}});
  }
  for (const auto& response : received.responses) take(response);
  for (const auto& status : received.statuses) take(status);
  if (link_.is_receiving()) return;
  summary_.refused += static_cast<int>(pending_hits_.size());
  pending_hits_.clear();
  ball_ = {};
  ball_.gain = gain_.now();
  ball_.problem = link_.problem();
  ball_.late = link_.is_late();
}

void Feel::take(const protocol::Reply& response) {
  if (response.result)
    refused_.clear();
  else if (auto why = refusal_reason(response.result.error()); !why.empty())
    refused_ = std::move(why);
  const auto pending = std::find(pending_hits_.begin(), pending_hits_.end(), response.id);
  if (pending == pending_hits_.end()) return;
  pending_hits_.erase(pending);
  ++(response.result ? summary_.pulses : summary_.refused);
}

void Feel::take(const protocol::Status& status) {
  const double passed_s =
      received_ns_ == 0
          ? 0.0
          : std::clamp(1e-9 * static_cast<double>(status.time_ns - received_ns_), 0.0, 1.0);
  received_ns_ = status.time_ns;
  gain_.take(status.derating, status.burst_s, passed_s);

  ball_.connected = true;
  ball_.late = false;
  ball_.problem = refused_;
  ball_.simulated = status.simulated;
  ball_.state = status.state;
  ball_.remedy = status.remedy.value_or("");
  ball_.gain = gain_.now();
  ball_.derating = status.derating;
  ball_.limit_a = status.limit_a;
  ball_.temperature_c = status.temperature_c.model;
  ball_.burst_s = status.burst_s;
  ball_.orientation.reset();
  if (status.orientation && status.orientation->age_ms <= kStaleMs)
    ball_.orientation = status.orientation->quaternion;

  if (gain_.now() < 1.0) summary_.turned_down_s += passed_s;
  if (status.derating) summary_.derated_s += passed_s;
  summary_.min_gain = std::min(summary_.min_gain, gain_.now());
  summary_.min_limit_a = std::min(summary_.min_limit_a.value_or(status.limit_a), status.limit_a);
  summary_.hottest_c = std::max(summary_.hottest_c, ball_.temperature_c);
  summary_.tripped = summary_.tripped || status.state == "tripped";
}

}  // namespace hedgehog::racer

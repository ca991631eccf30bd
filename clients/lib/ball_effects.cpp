// SPDX-License-Identifier: MIT
// Effects of a Ball.
#include <algorithm>
#include <utility>

#include "clients/lib/ball.h"

namespace hedgehog {
namespace {

using model::EffectMethod;
using protocol::EffectParams;
using protocol::EffectStart;

EffectStart pointed(EffectMethod method, protocol::Direction direction, EffectParams params) {
  params.direction = direction;
  return {method, std::move(params)};
}

}  // namespace

double felt_level(double strength, const protocol::HelloLimits& limits) noexcept {
  if (!(strength > 0.0) || !(limits.current_a > 0.0)) return 0.0;
  const double felt = std::min(1.0, limits.felt_a / limits.current_a);
  return felt + (1.0 - felt) * std::min(1.0, strength);
}

bool Ball::rumble(std::string_view slot, double strength,
                  std::optional<protocol::Direction> direction, EffectParams others) {
  if (!connected()) return false;
  if (!(strength > 0.0)) {
    protocol::EffectStop stop;
    stop.slot = std::string(slot);
    return notify(stop);
  }
  others.slot = std::string(slot);
  if (direction) others.direction = direction;
  others.level = felt_level(strength, hello_.limits);
  if (!others.lease_ms) others.lease_ms = kRumbleLeaseMs;
  return notify(EffectStart{EffectMethod::kVibrate, std::move(others)});
}

Ball::Admitted Ball::pulse(protocol::Direction direction, EffectParams others) {
  return call(pointed(EffectMethod::kPulse, direction, std::move(others)));
}
Ball::Admitted Ball::vibrate(protocol::Direction direction, EffectParams others) {
  return call(pointed(EffectMethod::kVibrate, direction, std::move(others)));
}
Ball::Admitted Ball::hold(protocol::Direction direction, EffectParams others) {
  return call(pointed(EffectMethod::kHold, direction, std::move(others)));
}
Ball::Admitted Ball::circle(protocol::Direction axis, EffectParams others) {
  others.axis = axis;
  return call(EffectStart{EffectMethod::kCircle, std::move(others)});
}
Ball::Admitted Ball::play(std::string pattern, EffectParams others) {
  others.pattern = std::move(pattern);
  return call(EffectStart{EffectMethod::kPlay, std::move(others)});
}

}  // namespace hedgehog

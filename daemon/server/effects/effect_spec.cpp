// SPDX-License-Identifier: MIT
#include "daemon/server/effects/effect_spec.h"

#include <optional>
#include <string>
#include <utility>

namespace hedgehog::server {
namespace {

using protocol::EffectParams;
using protocol::RpcError;

constexpr std::int64_t kFarthestStartNs = 10'000'000'000;

protocol::Result<double> strength_of(const EffectParams& p, const SpecFacts& f) {
  const bool coil = p.frame == model::Frame::kCoil;
  const double max_a = coil ? f.limits.continuous_a : f.limits.current_a;
  if (p.level) {
    const double requested_a = *p.level * f.limits.current_a;
    if (requested_a > max_a)
      return protocol::out_of_range("level", max_a / f.limits.current_a, *p.level);
    return requested_a;
  }
  if (p.force_n) {
    const double requested_a = *p.force_n / f.force_slope_n_a;
    // Allows the limit itself, converted to the force reported by `hello` and this error.
    if (requested_a > max_a * (1.0 + 1e-9))
      return protocol::out_of_range("force_n", max_a * f.force_slope_n_a, *p.force_n);
    return requested_a < max_a ? requested_a : max_a;
  }
  const double requested_a = p.current_a.value_or(f.limits.continuous_a);
  if (requested_a > max_a) return protocol::out_of_range("current_a", max_a, requested_a);
  return requested_a;
}

std::optional<RpcError> not_permitted(const EffectParams& p, const SpecFacts& f) {
  using protocol::Role;
  if (f.role >= Role::kOperate) return std::nullopt;
  if (p.frame == model::Frame::kCoil)
    return protocol::forbidden("frame", "coil", Role::kOperate, f.role);
  if (p.priority.value_or(5) > 7) {
    RpcError e =
        protocol::forbidden("priority", std::to_string(*p.priority), Role::kOperate, f.role);
    e.message = "priority: role play may use 0 to 7; 8 and 9 need operate";
    e.limit = std::int64_t{7};
    e.value = *p.priority;
    return e;
  }
  return std::nullopt;
}

template <class T>
void lay_over(std::optional<T>& base, const std::optional<T>& update) {
  if (update) base = update;
}

std::optional<RpcError> unfit(model::EffectMethod method, const EffectParams& base,
                              const EffectParams& update) {
  const bool leased = base.lease_ms.has_value();
  if (leased && update.duration_ms)
    return protocol::invalid_params("duration_ms", "this effect ends by its lease_ms");
  if (!leased && update.lease_ms)
    return protocol::invalid_params("lease_ms", "this effect ends by its duration_ms");
  if (leased && update.fade_ms.value_or(0) > 0)
    return protocol::invalid_params("fade_ms", "an effect with a lease has no end to fade to");
  const std::pair<bool, const char*> only_patterns[] = {{update.pattern.has_value(), "pattern"},
                                                        {update.keyframes.has_value(), "keyframes"},
                                                        {update.rotate_to.has_value(), "rotate_to"},
                                                        {update.rate.has_value(), "rate"},
                                                        {update.loop.has_value(), "loop"}};
  const bool play = method == model::EffectMethod::kPlay;
  for (const auto& [given, field] : only_patterns)
    if (given && !play)
      return protocol::invalid_params(field, "only an effect of effect.play has it");
  if (play && update.direction)
    return protocol::invalid_params("direction", "key frames have rotate_to instead");
  if (play && update.loop.value_or(false) && !leased && !base.duration_ms && !update.duration_ms) {
    return protocol::invalid_params(
        "loop", "this effect ends with its pattern; start it with lease_ms or duration_ms");
  }
  if (method == model::EffectMethod::kCircle) {
    return update.direction ? std::optional(protocol::invalid_params(
                                  "direction", "a circle has an axis instead"))
                            : std::nullopt;
  }
  const std::pair<bool, const char*> only_circles[] = {
      {update.axis.has_value(), "axis"},
      {update.ring_deg.has_value(), "ring_deg"},
      {update.speed_pins_s.has_value(), "speed_pins_s"},
      {update.sense.has_value(), "sense"},
      {update.stepping.has_value(), "stepping"}};
  for (const auto& [given, field] : only_circles)
    if (given) return protocol::invalid_params(field, "only a circle has it");
  return std::nullopt;
}

/// Sets the trajectory and the end of an effect that plays key frames.
std::optional<RpcError> set_keyframes(model::EffectSpec& s, const EffectParams& p,
                                      const SpecFacts& f, const KeyframeTrack& track) {
  s.trajectory.path = model::Path::kKeyframes;
  model::KeyframePlayback& out = s.trajectory.playback;
  out.count = static_cast<std::uint16_t>(track.frames.size());
  out.length_ms = static_cast<std::uint16_t>(track.length_ms());
  out.loop = p.loop.value_or(false);
  out.rate = p.rate.value_or(1.0);
  out.ends_with_pattern = !p.duration_ms && !p.lease_ms;
  if (p.rotate_to) {
    const auto towards = protocol::resolve(*p.rotate_to, f.pins, "rotate_to");
    if (towards.has_error()) return towards.error();
    out.turn = model::turn_from_front(*towards);
  }
  if (!out.ends_with_pattern) return std::nullopt;
  s.duration = model::ticks_to_end(out, 0.0);
  if (s.duration > protocol::kMaxDurationMs) {
    RpcError e = protocol::invalid_params(
        "duration_ms", "the pattern takes " + std::to_string(s.duration) +
                           " ms at this rate, more than 10000; set duration_ms or lease_ms");
    e.limit = protocol::kMaxDurationMs;
    e.value = s.duration;
    return e;
  }
  EffectParams whole = p;
  whole.duration_ms = s.duration;
  return protocol::check_end(whole);
}

}  // namespace

protocol::Result<model::EffectSpec> make_spec(model::EffectMethod method, const EffectParams& p,
                                              const SpecFacts& f, const KeyframeTrack* track) {
  if (const auto refused = not_permitted(p, f)) return *refused;
  model::EffectSpec s;
  s.method = method;
  s.frame = p.frame.value_or(s.frame);
  s.waveform = p.waveform.value_or(s.waveform);
  s.priority = static_cast<std::uint8_t>(p.priority.value_or(s.priority));
  s.finish_on_close = p.on_close == protocol::OnClose::kFinish;
  s.gain = p.gain.value_or(1.0);
  s.frequency_hz = p.frequency_hz.value_or(s.frequency_hz);
  s.on_fraction = p.on_fraction.value_or(s.on_fraction);
  s.envelope = {p.attack_ms.value_or(0), p.fade_ms.value_or(0), p.attack_level.value_or(0.0),
                p.fade_level.value_or(0.0)};
  s.delay = p.delay_ms.value_or(0);
  s.lease = p.lease_ms.value_or(0);
  s.duration = s.lease > 0 ? 0 : p.duration_ms.value_or(s.duration);

  const auto strength = strength_of(p, f);
  if (strength.has_error()) return strength.error();
  s.strength_a = *strength;

  if (method == model::EffectMethod::kCircle) {
    const auto axis = protocol::resolve(p.axis.value_or(protocol::Word::kUp), f.pins, "axis");
    if (axis.has_error()) return axis.error();
    s.trajectory.path = model::Path::kCircle;
    s.trajectory.axis = *axis;
    s.trajectory.ring_deg = p.ring_deg.value_or(s.trajectory.ring_deg);
    s.trajectory.pitch_deg = f.pin_pitch_deg;
    s.trajectory.speed_pins_s = p.speed_pins_s.value_or(s.trajectory.speed_pins_s);
    s.trajectory.clockwise = p.sense == protocol::Sense::kClockwise;
    s.trajectory.smooth = p.stepping == protocol::Stepping::kSmooth;
  } else if (track != nullptr) {
    if (auto wrong = set_keyframes(s, p, f, *track)) return std::move(*wrong);
  } else {
    const auto direction =
        protocol::resolve(p.direction.value_or(protocol::Word::kDown), f.pins, "direction");
    if (direction.has_error()) return direction.error();
    s.trajectory.direction = *direction;
  }

  if (p.start_at_ns) {
    const std::int64_t now_ns = f.epoch_ns + f.now * model::kNanosecondsPerTick;
    if (*p.start_at_ns > now_ns + kFarthestStartNs) {
      RpcError e = protocol::invalid_params("start_at_ns", "more than 10 s from now");
      e.limit = now_ns + kFarthestStartNs;
      e.value = *p.start_at_ns;
      return e;
    }
    const std::int64_t since = *p.start_at_ns > f.epoch_ns ? *p.start_at_ns - f.epoch_ns : 0;
    s.start_at = (since + model::kNanosecondsPerTick - 1) / model::kNanosecondsPerTick;
  }
  return s;
}

protocol::Result<EffectParams> merged(model::EffectMethod method, EffectParams base,
                                      const EffectParams& update) {
  if (const auto wrong = unfit(method, base, update)) return *wrong;
  if (update.level || update.current_a || update.force_n) {
    base.level = update.level;
    base.current_a = update.current_a;
    base.force_n = update.force_n;
  }
  if (update.start_at_ns || update.delay_ms) {
    base.start_at_ns = update.start_at_ns;
    base.delay_ms = update.delay_ms;
  }
  lay_over(base.direction, update.direction);
  lay_over(base.frame, update.frame);
  lay_over(base.gain, update.gain);
  lay_over(base.attack_ms, update.attack_ms);
  lay_over(base.fade_ms, update.fade_ms);
  lay_over(base.attack_level, update.attack_level);
  lay_over(base.fade_level, update.fade_level);
  lay_over(base.waveform, update.waveform);
  lay_over(base.frequency_hz, update.frequency_hz);
  lay_over(base.on_fraction, update.on_fraction);
  lay_over(base.duration_ms, update.duration_ms);
  lay_over(base.lease_ms, update.lease_ms);
  lay_over(base.on_close, update.on_close);
  lay_over(base.priority, update.priority);
  lay_over(base.if_limited, update.if_limited);
  lay_over(base.axis, update.axis);
  lay_over(base.ring_deg, update.ring_deg);
  lay_over(base.speed_pins_s, update.speed_pins_s);
  lay_over(base.sense, update.sense);
  lay_over(base.stepping, update.stepping);
  lay_over(base.rotate_to, update.rotate_to);
  lay_over(base.rate, update.rate);
  lay_over(base.loop, update.loop);
  if (const auto wrong = protocol::check_end(base)) return *wrong;
  return base;
}

}  // namespace hedgehog::server

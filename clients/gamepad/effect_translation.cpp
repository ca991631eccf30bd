// SPDX-License-Identifier: MIT
#include "clients/gamepad/effect_translation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "clients/gamepad/force_profile.h"

namespace hedgehog::gamepad {

namespace {

using protocol::EffectParams;
using protocol::EffectStart;

constexpr double kFullMotor = 0xffff;
constexpr std::uint16_t kSdlRumbleDirection = 0x4000;
// The two motors of a gamepad: a large slow one and a small fast one.
constexpr double kStrongHz = 60.0;
constexpr double kWeakHz = 160.0;
// SDL's rumble has a period of 1000 ms, which is not that of a motor.
constexpr double kMinRumbleHz = 10.0;
constexpr double kMinHz = 0.5;
constexpr double kMaxHz = 250.0;

double felt(double force, const TranslationOptions& options) {
  if (force == 0.0) return 0.0;
  const double strength = std::min(1.0, std::abs(force));
  return options.felt_level + (options.full_level - options.felt_level) * strength;
}

protocol::Direction side_of(std::uint16_t direction, bool opposite = false) {
  const auto towards = static_cast<std::uint16_t>(direction + (opposite ? 0x8000 : 0));
  return protocol::Angles{-360.0 * towards / 65'536.0, 0.0};
}

struct Wave {
  model::Waveform waveform = model::Waveform::kConstant;
  double frequency_hz = kStrongHz;
};

/// A constant push or wave.
EffectStart steady(const protocol::Direction& side, double level, const std::optional<Wave>& wave) {
  EffectParams params;
  params.direction = side;
  params.level = level;
  if (!wave) return {model::EffectMethod::kHold, params};
  params.waveform = wave->waveform;
  params.frequency_hz = wave->frequency_hz;
  return {model::EffectMethod::kVibrate, params};
}

bool is_steady(const std::vector<ForcePoint>& profile) {
  return std::all_of(
      profile.begin(), profile.end(),
      [&](const ForcePoint& point) { return point.force == profile.front().force; });
}

struct Sides {
  protocol::Direction positive;
  protocol::Direction negative;
};

std::optional<EffectStart> play(const std::vector<ForcePoint>& profile, const Sides& sides,
                                std::int64_t length_ms, const std::optional<Wave>& wave,
                                const TranslationOptions& options) {
  double peak = 0.0;
  for (const ForcePoint& point : profile) peak = std::max(peak, felt(point.force, options));
  if (peak == 0.0) return std::nullopt;
  if (is_steady(profile))
    return steady(profile.front().force < 0.0 ? sides.negative : sides.positive, peak, wave);

  std::vector<protocol::Keyframe> keyframes;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const ForcePoint& point = profile[i];
    // At a change of sign the side changes while the force is 0.
    const double next = i + 1 < profile.size() ? profile[i + 1].force : point.force;
    const bool negative = point.force < 0.0 || (point.force == 0.0 && next < 0.0);
    if (point.force == 0.0 && i > 0)
      keyframes.push_back({.t_ms = point.t_ms, .direction = keyframes.back().direction});
    keyframes.push_back({.t_ms = point.t_ms,
                         .direction = negative ? sides.negative : sides.positive,
                         .level = felt(point.force, options) / peak});
  }
  if (keyframes.back().t_ms < length_ms) {
    auto last = keyframes.back();
    last.t_ms = length_ms;
    keyframes.push_back(last);
  }
  EffectParams params;
  params.level = peak;
  params.keyframes = std::move(keyframes);
  if (wave) {
    params.waveform = wave->waveform;
    params.frequency_hz = wave->frequency_hz;
  }
  return EffectStart{model::EffectMethod::kPlay, params};
}

std::optional<EffectStart> rumble(const ff_rumble_effect& motors,
                                  const TranslationOptions& options) {
  const double strong = motors.strong_magnitude / kFullMotor;
  const double weak = motors.weak_magnitude / kFullMotor;
  if (strong + weak == 0.0) return std::nullopt;
  const double share = weak / (strong + weak);
  const Wave wave{model::Waveform::kSquare, kStrongHz + share * (kWeakHz - kStrongHz)};
  return steady(options.rumble_direction, felt(std::max(strong, weak), options), wave);
}

model::Waveform waveform_of(std::uint16_t waveform) {
  switch (waveform) {
    case FF_SQUARE:
      return model::Waveform::kSquare;
    case FF_TRIANGLE:
      return model::Waveform::kTriangle;
    case FF_SINE:
      return model::Waveform::kSine;
    default:
      return model::Waveform::kSawtooth;
  }
}

std::optional<EffectStart> periodic(const ff_effect& effect, const TranslatedEffect& timing,
                                    const TranslationOptions& options) {
  const ff_periodic_effect& given = effect.u.periodic;
  const double offset = given.offset / kFullForce;
  const double peak = std::abs(given.magnitude / kFullForce) + std::abs(offset);
  const bool opposite = offset < 0.0 && std::abs(given.offset) > std::abs(given.magnitude);
  const double force = std::min(1.0, peak);
  Wave wave{waveform_of(given.waveform), kStrongHz};
  if (given.period > 0) wave.frequency_hz = std::clamp(1000.0 / given.period, kMinHz, kMaxHz);
  Sides sides{side_of(effect.direction, opposite), side_of(effect.direction, !opposite)};
  if (options.sdl_rumble && effect.direction == kSdlRumbleDirection) {
    sides = {options.rumble_direction, options.rumble_direction};
    if (wave.frequency_hz < kMinRumbleHz) wave.frequency_hz = kStrongHz;
  }
  const std::int64_t length_ms = timing.length.count();
  const auto profile =
      force_profile(force, force, length_ms, given.envelope, effect.replay.length != 0);
  return play(profile, sides, length_ms, wave, options);
}

std::optional<EffectStart> slope(const ff_effect& effect, std::int16_t begin, std::int16_t end,
                                 const ff_envelope& envelope, const TranslatedEffect& timing,
                                 const TranslationOptions& options) {
  const auto force = [](std::int16_t level) { return std::max(-1.0, level / kFullForce); };
  const std::int64_t length_ms = timing.length.count();
  const auto profile =
      force_profile(force(begin), force(end), length_ms, envelope, effect.replay.length != 0);
  const Sides sides{side_of(effect.direction), side_of(effect.direction, true)};
  return play(profile, sides, length_ms, std::nullopt, options);
}

}  // namespace

bool can_translate(const ff_effect& effect) noexcept {
  if (effect.type == FF_PERIODIC)
    return effect.u.periodic.waveform >= FF_SQUARE && effect.u.periodic.waveform <= FF_SAW_DOWN;
  return effect.type == FF_RUMBLE || effect.type == FF_CONSTANT || effect.type == FF_RAMP;
}

TranslatedEffect translate(const ff_effect& effect, const TranslationOptions& options) {
  TranslatedEffect translated;
  translated.delay = Milliseconds(effect.replay.delay);
  if (effect.replay.length != 0)
    translated.length = std::min(Milliseconds(effect.replay.length), kMaxPlay);
  if (effect.type == FF_RUMBLE) {
    translated.start = rumble(effect.u.rumble, options);
  } else if (effect.type == FF_PERIODIC) {
    translated.start = periodic(effect, translated, options);
  } else if (effect.type == FF_CONSTANT) {
    const auto& given = effect.u.constant;
    translated.start = slope(effect, given.level, given.level, given.envelope, translated, options);
  } else {
    const auto& given = effect.u.ramp;
    // Without an end a ramp has no slope.
    const std::int16_t end = effect.replay.length != 0 ? given.end_level : given.start_level;
    translated.start = slope(effect, given.start_level, end, given.envelope, translated, options);
  }
  return translated;
}

}  // namespace hedgehog::gamepad

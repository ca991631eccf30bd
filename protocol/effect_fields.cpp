// SPDX-License-Identifier: MIT
#include <cmath>
#include <initializer_list>
#include <utility>

#include "protocol/describe.h"

namespace hedgehog::protocol {
namespace {

constexpr Spec kFraction{.min = 0, .max = 1};
constexpr Spec kNotNegative{.min = 0};
constexpr Spec kUpToTenSeconds{.min = 0, .max = kMaxDurationMs, .rounded = true};
constexpr Spec kDuration{.min = 1, .max = kMaxDurationMs, .rounded = true};
constexpr Spec kFrequency{.min = 0.5, .max = 250};
constexpr Spec kOnFraction{.min = 0.05, .max = 0.95};
constexpr Spec kKeyframes{.items = model::kMaxKeyframes};
constexpr Spec kLease{.min = kMinLeaseMs, .max = kMaxLeaseMs, .rounded = true};

/// Refuses when more than one of them was said; `names` reads "level, current_a and force_n".
void at_most_one(Fields& f, std::string_view names,
                 std::initializer_list<std::pair<std::string_view, bool>> given) {
  std::string_view first;
  for (const auto& [name, is_given] : given) {
    if (is_given && !first.empty()) {
      f.fail(invalid_params(
          name, std::string(first) + " is said too; say only one of " + std::string(names)));
      return;
    }
    first = is_given ? name : first;
  }
}

}  // namespace

std::optional<RpcError> check_end(const EffectParams& v) {
  if (v.lease_ms && v.fade_ms.value_or(0) > 0)
    return invalid_params("fade_ms", "an effect with lease_ms has no known end to fade to");
  if (v.lease_ms && v.on_close == OnClose::kFinish)
    return invalid_params("on_close", "only an effect with duration_ms can finish");
  const std::optional<std::int64_t>& duration = v.duration_ms;
  if (!duration) return std::nullopt;
  const std::int64_t attack = v.attack_ms.value_or(0);
  const std::int64_t fade = v.fade_ms.value_or(0);
  if (attack + fade > *duration) {
    const bool by_fade = fade > 0;
    RpcError error =
        invalid_params(by_fade ? "fade_ms" : "attack_ms",
                       "attack and fade are " + std::to_string(attack + fade) +
                           " ms together, longer than duration_ms " + std::to_string(*duration));
    error.limit = *duration - (by_fade ? attack : 0);
    error.value = by_fade ? fade : attack;
    return error;
  }
  if (v.on_close == OnClose::kFinish && *duration > kMaxFinishMs) {
    RpcError error = invalid_params(
        "duration_ms", std::to_string(*duration) + " is above " + std::to_string(kMaxFinishMs) +
                           ", the most that on_close \"finish\" allows");
    error.limit = kMaxFinishMs;
    error.value = *duration;
    return error;
  }
  return std::nullopt;
}

std::optional<RpcError> check_keyframes(const std::vector<Keyframe>& keyframes) {
  const auto at = [](std::size_t index) { return "keyframes[" + std::to_string(index) + "].t_ms"; };
  for (std::size_t i = 1; i < keyframes.size(); ++i) {
    const std::int64_t before = keyframes[i - 1].t_ms;
    if (keyframes[i].t_ms < before) {
      return out_of_range(at(i), static_cast<double>(before),
                          static_cast<double>(keyframes[i].t_ms));
    }
  }
  if (keyframes.empty() || keyframes.back().t_ms < 1)
    return invalid_params("keyframes", "the last t_ms must be at least 1");
  return std::nullopt;
}

namespace {

void check(Fields& f, const EffectParams& v, Method method) {
  at_most_one(f, "level, current_a and force_n",
              {{"level", v.level.has_value()},
               {"current_a", v.current_a.has_value()},
               {"force_n", v.force_n.has_value()}});
  at_most_one(f, "start_at_ns and delay_ms",
              {{"start_at_ns", v.start_at_ns.has_value()}, {"delay_ms", v.delay_ms.has_value()}});
  at_most_one(f, "duration_ms and lease_ms",
              {{"duration_ms", v.duration_ms.has_value()}, {"lease_ms", v.lease_ms.has_value()}});
  at_most_one(f, "pattern and keyframes",
              {{"pattern", v.pattern.has_value()}, {"keyframes", v.keyframes.has_value()}});
  if (v.keyframes) {
    if (auto wrong = check_keyframes(*v.keyframes)) f.fail(*std::move(wrong));
  }
  if (method == Method::kEffectPlay && !v.pattern && !v.keyframes)
    f.fail(invalid_params("pattern", "is missing; say the name of one, or keyframes"));
  if (auto wrong = check_end(method == Method::kEffectUpdate ? v : with_defaults(method, v)))
    f.fail(*std::move(wrong));
  if ((method == Method::kEffectPulse || method == Method::kEffectHold) && !v.direction)
    f.fail(invalid_params("direction", "is missing; for example \"direction\":\"left\""));
}

}  // namespace

void describe(Fields& f, Keyframe& v) {
  f.required("t_ms", v.t_ms, {.min = 0, .max = model::kMaxKeyframeMs, .rounded = true});
  f.optional("direction", v.direction);
  f.required("level", v.level, kFraction);
  f.optional("ease", v.ease);
}

void describe(Fields& f, EffectParams& v, Method method) {
  const bool circle = method == Method::kEffectCircle;
  const bool update = method == Method::kEffectUpdate;
  const bool play = method == Method::kEffectPlay;
  if (!circle && !play) f.optional("direction", v.direction);
  if (play || update) {
    f.optional("pattern", v.pattern, {.min = 1, .max = kMaxPatternName});
    f.optional("keyframes", v.keyframes, kKeyframes);
    f.optional("rotate_to", v.rotate_to);
    f.optional("rate", v.rate, {.min = 0.1, .max = 10});
    f.optional("loop", v.loop);
  }
  if (circle || update) {
    f.optional("axis", v.axis);
    f.optional("ring_deg", v.ring_deg, {.min = 0, .max = 180});
    f.optional("speed_pins_s", v.speed_pins_s, {.min = 0.1, .max = 100});
    f.optional("sense", v.sense);
    f.optional("stepping", v.stepping);
  }
  f.optional("frame", v.frame);
  f.optional("level", v.level, kFraction);
  f.optional("current_a", v.current_a, kNotNegative);
  f.optional("force_n", v.force_n, kNotNegative);
  f.optional("gain", v.gain, kFraction);
  f.optional("start_at_ns", v.start_at_ns, kNotNegative);
  f.optional("delay_ms", v.delay_ms, kUpToTenSeconds);
  f.optional("attack_ms", v.attack_ms, kUpToTenSeconds);
  f.optional("fade_ms", v.fade_ms, kUpToTenSeconds);
  f.optional("attack_level", v.attack_level, kFraction);
  f.optional("fade_level", v.fade_level, kFraction);
  f.optional("waveform", v.waveform);
  f.optional("frequency_hz", v.frequency_hz, kFrequency);
  f.optional("on_fraction", v.on_fraction, kOnFraction);
  f.optional("duration_ms", v.duration_ms, kDuration);
  f.optional("lease_ms", v.lease_ms, kLease);
  f.optional("on_close", v.on_close);
  f.optional("slot", v.slot, {.min = 1, .max = kMaxSlotCharacters});
  f.optional("priority", v.priority, {.min = 0, .max = 9});
  f.optional("if_limited", v.if_limited);
  if (f.checks()) check(f, v, method);
}

EffectParams with_defaults(Method method, EffectParams params) {
  const auto fill = [](auto& field, auto value) {
    if (!field) field = value;
  };
  const bool circle = method == Method::kEffectCircle;
  const bool vibrate = method == Method::kEffectVibrate;
  if (circle) {
    fill(params.axis, Direction{Word::kUp});
    fill(params.ring_deg, 90.0);
    fill(params.speed_pins_s, 10.0);
    fill(params.sense, Sense::kCounterClockwise);
    fill(params.stepping, Stepping::kPin);
  }
  if (vibrate) fill(params.direction, Direction{Word::kDown});
  const bool play = method == Method::kEffectPlay;
  if (play) {
    fill(params.rate, 1.0);
    fill(params.loop, false);
  }
  fill(params.frame, model::Frame::kDevice);
  fill(params.gain, 1.0);
  fill(params.attack_ms, std::int64_t{0});
  fill(params.fade_ms, std::int64_t{0});
  fill(params.attack_level, 0.0);
  fill(params.fade_level, 0.0);
  fill(params.waveform, vibrate ? model::Waveform::kSquare : model::Waveform::kConstant);
  fill(params.frequency_hz, 60.0);
  fill(params.on_fraction, 0.5);
  if (!params.duration_ms && !params.lease_ms) {
    constexpr std::int64_t kPulseMs = 150;
    constexpr std::int64_t kSecondMs = 1000;
    if (method == Method::kEffectHold || params.loop.value_or(false))
      params.lease_ms = kSecondMs;
    else if (!play)
      params.duration_ms = method == Method::kEffectPulse ? kPulseMs : kSecondMs;
  }
  fill(params.on_close, OnClose::kStop);
  fill(params.priority, std::int64_t{5});
  fill(params.if_limited, IfLimited::kReduce);
  return params;
}

std::optional<model::EffectMethod> effect_of(Method method) noexcept {
  switch (method) {
    case Method::kEffectPulse:
      return model::EffectMethod::kPulse;
    case Method::kEffectCircle:
      return model::EffectMethod::kCircle;
    case Method::kEffectVibrate:
      return model::EffectMethod::kVibrate;
    case Method::kEffectHold:
      return model::EffectMethod::kHold;
    case Method::kEffectPlay:
      return model::EffectMethod::kPlay;
    default:
      return std::nullopt;
  }
}

Method method_of(model::EffectMethod effect) noexcept {
  switch (effect) {
    case model::EffectMethod::kCircle:
      return Method::kEffectCircle;
    case model::EffectMethod::kVibrate:
      return Method::kEffectVibrate;
    case model::EffectMethod::kHold:
      return Method::kEffectHold;
    case model::EffectMethod::kPlay:
      return Method::kEffectPlay;
    case model::EffectMethod::kPulse:
      break;
  }
  return Method::kEffectPulse;
}

}  // namespace hedgehog::protocol

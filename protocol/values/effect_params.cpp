// SPDX-License-Identifier: MIT
#include "protocol/values/effect_params.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "protocol/wire/fields.h"

namespace hedgehog::protocol {
namespace {

using model::EffectMethod;

constexpr std::array<std::string_view, 2> kOnClose{"stop", "finish"};
constexpr std::array<std::string_view, 2> kIfLimited{"reduce", "refuse"};
constexpr std::array<std::string_view, 2> kSenses{"ccw", "cw"};
constexpr std::array<std::string_view, 2> kSteppings{"pin", "smooth"};

constexpr Spec kFraction{.min = 0, .max = 1};
constexpr Spec kNotNegative{.min = 0};
constexpr Spec kUpToTenSeconds{.min = 0, .max = kMaxDurationMs, .rounded = true};
constexpr Spec kDuration{.min = 1, .max = kMaxDurationMs, .rounded = true};
constexpr Spec kFrequency{.min = 0.5, .max = 250};
constexpr Spec kOnFraction{.min = 0.05, .max = 0.95};
constexpr Spec kKeyframes{.items = model::kMaxKeyframes};
constexpr Spec kLease{.min = kMinLeaseMs, .max = kMaxLeaseMs, .rounded = true};

/// Rejects more than one given; `names` is like "level, current_a and force_n".
void at_most_one(Fields& f, std::string_view names,
                 std::initializer_list<std::pair<std::string_view, bool>> given) {
  std::string_view first;
  for (const auto& [name, is_given] : given) {
    if (is_given && !first.empty()) {
      f.fail(invalid_params(
          name, std::string(first) + " is given too; give only one of " + std::string(names)));
      return;
    }
    first = is_given ? name : first;
  }
}

}  // namespace

Names names_of(OnClose) noexcept { return kOnClose; }
Names names_of(IfLimited) noexcept { return kIfLimited; }
Names names_of(Sense) noexcept { return kSenses; }
Names names_of(Stepping) noexcept { return kSteppings; }

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

void check(Fields& f, const EffectParams& v, std::optional<EffectMethod> method) {
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
  if (method == EffectMethod::kPlay && !v.pattern && !v.keyframes)
    f.fail(invalid_params("pattern", "is missing; give the name of one, or keyframes"));
  if (auto wrong = check_end(method ? with_defaults(*method, v) : v)) f.fail(*std::move(wrong));
  if ((method == EffectMethod::kPulse || method == EffectMethod::kHold) && !v.direction)
    f.fail(invalid_params("direction", "is missing; for example \"direction\":\"left\""));
}

}  // namespace

void Keyframe::describe(Fields& f) {
  f.required("t_ms", t_ms, {.min = 0, .max = model::kMaxKeyframeMs, .rounded = true});
  f.optional("direction", direction);
  f.required("level", level, kFraction);
  f.optional("ease", ease);
}

void EffectParams::describe(Fields& f, std::optional<EffectMethod> method) {
  const bool circle = method == EffectMethod::kCircle;
  const bool update = !method;
  const bool play = method == EffectMethod::kPlay;
  if (!circle && !play) f.optional("direction", direction);
  if (play || update) {
    f.optional("pattern", pattern, {.min = 1, .max = kMaxPatternName});
    f.optional("keyframes", keyframes, kKeyframes);
    f.optional("rotate_to", rotate_to);
    f.optional("rate", rate, {.min = 0.1, .max = 10});
    f.optional("loop", loop);
  }
  if (circle || update) {
    f.optional("axis", axis);
    f.optional("ring_deg", ring_deg, {.min = 0, .max = 180});
    f.optional("speed_pins_s", speed_pins_s, {.min = 0.1, .max = 100});
    f.optional("sense", sense);
    f.optional("stepping", stepping);
  }
  f.optional("frame", frame);
  f.optional("level", level, kFraction);
  f.optional("current_a", current_a, kNotNegative);
  f.optional("force_n", force_n, kNotNegative);
  f.optional("gain", gain, kFraction);
  f.optional("start_at_ns", start_at_ns, kNotNegative);
  f.optional("delay_ms", delay_ms, kUpToTenSeconds);
  f.optional("attack_ms", attack_ms, kUpToTenSeconds);
  f.optional("fade_ms", fade_ms, kUpToTenSeconds);
  f.optional("attack_level", attack_level, kFraction);
  f.optional("fade_level", fade_level, kFraction);
  f.optional("waveform", waveform);
  f.optional("frequency_hz", frequency_hz, kFrequency);
  f.optional("on_fraction", on_fraction, kOnFraction);
  f.optional("duration_ms", duration_ms, kDuration);
  f.optional("lease_ms", lease_ms, kLease);
  f.optional("on_close", on_close);
  f.optional("slot", slot, {.min = 1, .max = kMaxSlotCharacters});
  f.optional("priority", priority, {.min = 0, .max = 9});
  f.optional("if_limited", if_limited);
  if (f.checks()) check(f, *this, method);
}

EffectParams with_defaults(EffectMethod method, EffectParams params) {
  const auto fill = [](auto& field, auto value) {
    if (!field) field = value;
  };
  const bool circle = method == EffectMethod::kCircle;
  const bool vibrate = method == EffectMethod::kVibrate;
  if (circle) {
    fill(params.axis, Direction{Word::kUp});
    fill(params.ring_deg, 90.0);
    fill(params.speed_pins_s, 10.0);
    fill(params.sense, Sense::kCounterClockwise);
    fill(params.stepping, Stepping::kPin);
  }
  if (vibrate) fill(params.direction, Direction{Word::kDown});
  const bool play = method == EffectMethod::kPlay;
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
    if (method == EffectMethod::kHold || params.loop.value_or(false))
      params.lease_ms = kSecondMs;
    else if (!play)
      params.duration_ms = method == EffectMethod::kPulse ? kPulseMs : kSecondMs;
  }
  fill(params.on_close, OnClose::kStop);
  fill(params.priority, std::int64_t{5});
  fill(params.if_limited, IfLimited::kReduce);
  return params;
}

}  // namespace hedgehog::protocol

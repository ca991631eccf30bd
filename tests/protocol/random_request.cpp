// SPDX-License-Identifier: MIT
#include "tests/protocol/random_request.h"

#include "protocol/methods.h"
#include "tests/protocol/schema.h"

namespace hedgehog::protocol {
namespace {

bool random_bool() { return *rc::gen::inRange(0, 2) == 1; }

std::int64_t integer(std::int64_t low, std::int64_t high) {
  return *rc::gen::inRange(low, high + 1);
}

double between(double low, double high) {
  constexpr int kSteps = 1'000'000;
  return low + (high - low) * *rc::gen::inRange(0, kSteps + 1) / kSteps;
}

template <class E>
E enumerator() {
  const auto count = static_cast<int>(names_of(E{}).size());
  return static_cast<E>(*rc::gen::inRange(0, count));
}

template <class T, class Make>
void maybe(std::optional<T>& field, Make make) {
  if (random_bool()) field = make();
}

std::string slot() {
  return *rc::gen::elementOf(
      std::vector<std::string>{"engine", "skid", "a \"quoted\" one", "Bäume", "\\", "🦔"});
}

Direction direction() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return model::Vec3{between(-9, 9), between(-9, 9), between(0.1, 9)};
    case 1:
      return Angles{between(-360, 360), between(-90, 90)};
    case 2:
      return PinNumber{integer(0, 85)};
    default:
      return enumerator<Word>();
  }
}

model::Quaternion quaternion() {
  return model::axis_angle({0, 0, 1}, 0) == model::Quaternion{} && random_bool()
             ? model::Quaternion{}
             : model::Quaternion{0, random_bool() ? 1.0 : -1.0, 0, 0};
}

std::vector<Keyframe> keyframes() {
  std::vector<Keyframe> made(static_cast<std::size_t>(integer(1, 6)));
  std::int64_t t_ms = 0;
  for (Keyframe& k : made) {
    t_ms += integer(1, 9000);
    k.t_ms = t_ms;
    k.level = between(0, 1);
    maybe(k.direction, direction);
    maybe(k.ease, enumerator<model::Ease>);
  }
  return made;
}

std::string pattern_name() {
  return *rc::gen::elementOf(std::vector<std::string>{"heartbeat", "acme/knock-2", "a/b.c_d"});
}

Pattern pattern() {
  Pattern made{.name = pattern_name(), .description = slot(), .keyframes = keyframes()};
  maybe(made.waveform, enumerator<model::Waveform>);
  maybe(
      made.frequency_hz, [] { return between(0.5, 250); });
  maybe(made.on_fraction, [] { return between(0.05, 0.95); });
  return made;
}

void fill_end(EffectParams& p, std::int64_t default_ms) {
  const int kind = *rc::gen::inRange(0, 3);
  if (kind == 1) {
    p.lease_ms = integer(kMinLeaseMs, kMaxLeaseMs);
    maybe(p.attack_ms, [] { return integer(0, 10'000); });
    return;
  }
  if (kind == 2) p.duration_ms = integer(1, kMaxDurationMs);
  const std::int64_t duration = p.duration_ms.value_or(default_ms);
  maybe(
      p.attack_ms, [&] { return integer(0, duration); });
  maybe(
      p.fade_ms, [&] { return integer(0, duration - p.attack_ms.value_or(0)); });
  maybe(p.on_close, [&] {
    return random_bool() && duration <= kMaxFinishMs ? OnClose::kFinish : OnClose::kStop;
  });
}

/// For a start; nullopt: for an update.
EffectParams effect_params(std::optional<model::EffectMethod> method) {
  EffectParams p;
  const bool circle = method == model::EffectMethod::kCircle;
  const bool update = !method;
  const bool play = method == model::EffectMethod::kPlay;
  if (method == model::EffectMethod::kPulse || method == model::EffectMethod::kHold)
    p.direction = direction();
  else if (!circle && !play)
    maybe(p.direction, direction);
  if (play || update) {
    if (random_bool())
      p.pattern = pattern_name();
    else if (play || random_bool())
      p.keyframes = keyframes();
    maybe(p.rotate_to, direction);
    maybe(p.rate, [] { return between(0.1, 10); });
    maybe(p.loop, random_bool);
  }
  if (circle || update) {
    maybe(p.axis, direction);
    maybe(
        p.ring_deg, [] { return between(0, 180); });
    maybe(p.speed_pins_s, [] { return between(0.1, 100); });
    maybe(p.sense, enumerator<Sense>);
    maybe(p.stepping, enumerator<Stepping>);
  }
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      p.level = between(0, 1);
      break;
    case 1:
      p.current_a = between(0, 15);
      break;
    case 2:
      p.force_n = between(0, 0.2);
      break;
    default:
      break;
  }
  maybe(p.frame, enumerator<model::Frame>);
  maybe(p.gain, [] { return between(0, 1); });
  if (random_bool())
    maybe(p.start_at_ns, [] { return integer(0, std::int64_t{1} << 60); });
  else
    maybe(
        p.delay_ms, [] { return integer(0, 10'000); });
  maybe(
      p.attack_level, [] { return between(0, 1); });
  maybe(p.fade_level, [] { return between(0, 1); });
  maybe(p.waveform, enumerator<model::Waveform>);
  maybe(
      p.frequency_hz, [] { return between(0.5, 250); });
  maybe(p.on_fraction, [] { return between(0.05, 0.95); });
  if (method == model::EffectMethod::kHold) {
    p.lease_ms = integer(kMinLeaseMs, kMaxLeaseMs);
  } else {
    fill_end(p, method == model::EffectMethod::kPulse ? 150 : 1000);
    if (p.loop.value_or(false) && !p.duration_ms) {
      p.fade_ms.reset();
      p.on_close.reset();
    }
  }
  maybe(p.priority, [] { return integer(0, 9); });
  maybe(p.if_limited, enumerator<IfLimited>);
  return p;
}

EffectStart start() {
  const auto method = enumerator<model::EffectMethod>();
  EffectStart made{method, effect_params(method)};
  maybe(made.params.slot, slot);
  return made;
}

EffectNumber number() { return static_cast<EffectNumber>(integer(1, 4'294'967'295)); }

ThermalForecast forecast() {
  ThermalForecast made;
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      made.current_a = between(0, 15);
      maybe(made.direction, direction);
      break;
    case 1:
      made.start = start();
      break;
    default:
      made.effect = number();
  }
  return made;
}

TelemetrySubscribe telemetry() {
  TelemetrySubscribe made;
  made.rate_hz = between(0.1, 200);
  if (random_bool()) {
    made.fields = {};
    made.fields.add(enumerator<StatusKey>());
    made.fields.add(enumerator<StatusKey>());
  }
  return made;
}

SimSet sim_set() {
  SimSet made;
  maybe(made.orientation, quaternion);
  maybe(
      made.ambient_c, [] { return between(-20, 60); });
  maybe(
      made.errors,
      [] {
        return std::vector<SimError>{{"current_gain", integer(0, 2), 1.05, 120.0},
                                     {"cooling_gain", std::nullopt, 0.5, 0.0}};
      });
  maybe(made.fault, [] { return SimFault{{"fan_stopped", "sensor_open"}, integer(0, 2)}; });
  return made;
}

Request filled(Request request) {
  if (auto* hello = std::get_if<Hello>(&request)) {
    hello->client = slot();
    hello->protocol = random_bool() ? "1.0" : "";
    maybe(hello->token, slot);
  } else if (auto* update = std::get_if<EffectUpdate>(&request)) {
    update->params = effect_params(std::nullopt);
    if (random_bool())
      update->effect = number();
    else
      update->params.slot = slot();
  } else if (auto* stop = std::get_if<EffectStop>(&request)) {
    random_bool() ? void(stop->effect = number()) : void(stop->slot = slot());
  } else if (auto* all = std::get_if<EffectStopAll>(&request)) {
    all->scope = enumerator<Scope>();
  } else if (auto* claim = std::get_if<DeviceClaim>(&request)) {
    claim->lease_ms = integer(kMinLeaseMs, kMaxLeaseMs);
  } else if (auto* gain = std::get_if<OutputSetGain>(&request)) {
    gain->gain = between(0, 1);
  } else if (auto* orientation = std::get_if<OrientationSet>(&request)) {
    orientation->quaternion = quaternion();
  } else if (auto* recenter = std::get_if<OrientationRecenter>(&request)) {
    recenter->azimuth_deg = between(-360, 360);
  } else if (auto* events = std::get_if<EventsSubscribe>(&request)) {
    events->types =
        random_bool() ? std::vector<std::string>{"overrun"} : std::vector<std::string>{};
    events->scope = enumerator<Scope>();
  } else if (auto* preview = std::get_if<EffectPreview>(&request)) {
    preview->start = start();
  } else if (auto* history = std::get_if<EventsHistory>(&request)) {
    maybe(history->since, [] { return std::string("2026-11-20T23:14:07.5+01:00"); });
    history->types =
        random_bool() ? std::vector<std::string>{"overrun"} : std::vector<std::string>{};
    history->limit = integer(1, 1000);
  } else if (auto* put = std::get_if<PatternPut>(&request)) {
    put->pattern = pattern();
  } else if (auto* get = std::get_if<PatternGet>(&request)) {
    get->name = pattern_name();
  } else if (auto* remove = std::get_if<PatternRemove>(&request)) {
    remove->name = pattern_name();
  } else if (std::holds_alternative<EffectStart>(request)) {
    request = start();
  } else if (std::holds_alternative<ThermalForecast>(request)) {
    request = forecast();
  } else if (std::holds_alternative<TelemetrySubscribe>(request)) {
    request = telemetry();
  } else if (std::holds_alternative<SimSet>(request)) {
    request = sim_set();
  }
  return request;
}

}  // namespace

Method random_method() {
  return static_cast<Method>(*rc::gen::inRange(0, static_cast<int>(kMethods.size())));
}

rc::Gen<Request> random_request() {
  return rc::gen::exec([] { return filled(empty_request(random_method())); });
}

std::vector<std::string> parameter_names(Method method) {
  const Json schema = schema_of_params(method);
  std::vector<std::string> names;
  for (const auto& [name, property] : *schema.find("properties")->as<Json::Object>())
    names.push_back(name);
  return names;
}

}  // namespace hedgehog::protocol

// SPDX-License-Identifier: MIT
#include "protocol/describe.h"

namespace hedgehog::protocol {
namespace {

constexpr Spec kAmps = decimals(2);
constexpr Spec kNewtons = decimals(4);
constexpr Spec kMillimetres = decimals(3);
constexpr Spec kDegreesC = decimals(2);
constexpr Spec kSeconds = decimals(1);
constexpr Spec kRatio = decimals(3);
constexpr Spec kUnit = decimals(5);

void describe_only(Fields& f, Status& v, StatusKeys keys) {
  // Each key is described where it stands, so that the order of the object is that of the enum.
  const auto shows = [&](StatusKey key) { return keys.contains(key); };
  const auto required = [&](StatusKey key, auto& value, const Spec& spec = {}) {
    if (shows(key)) f.required(name(key), value, spec);
  };
  const auto nullable = [&](StatusKey key, auto& value, const Spec& spec = {}) {
    if (shows(key)) {
      f.nullable(name(key), value, spec);
    }
  };
  using enum StatusKey;
  required(kDevice, v.device);
  required(kSimulated, v.simulated);
  required(kTimeNs, v.time_ns);
  required(kState, v.state);
  nullable(kReason, v.reason);
  required(kSinceS, v.since_s, kSeconds);
  nullable(kRemedy, v.remedy);
  required(kTemperatureC, v.temperature_c);
  required(kLimitA, v.limit_a, kAmps);
  nullable(kHeadroomS, v.headroom_s, kSeconds);
  nullable(kBurstS, v.burst_s, kSeconds);
  required(kDerating, v.derating);
  // As finely as the board measures: what calibrates a ball is worked out from these.
  required(kCurrentA, v.current_a, decimals(3));
  required(kDuty, v.duty, decimals(5));
  nullable(kSupplyV, v.supply_v, decimals(3));
  required(kField, v.field, kUnit);
  required(kForceN, v.force_n, kNewtons);
  nullable(kPin, v.pin);
  required(kFan, v.fan);
  nullable(kOrientation, v.orientation);
  required(kEffects, v.effects);
  required(kLoop, v.loop);
  required(kLink, v.link);
  required(kAppliedSeq, v.applied_seq);
  nullable(kLastTrip, v.last_trip);
  required(kPins, v.pins);
}

}  // namespace

void describe(Fields& f, TemperatureStatus& v) {
  f.nullable("sensor", v.sensor, kDegreesC);
  f.nullable("model", v.model, kDegreesC);
  f.required("coils", v.coils, kDegreesC);
  f.optional("upper", v.upper, kDegreesC);
  f.optional("core", v.core, kDegreesC);
  f.optional("sensors", v.sensors, kDegreesC);
  f.optional("skin", v.skin, kDegreesC);
  f.nullable("age_ms", v.age_ms);
  f.optional("thermometer", v.thermometer, kDegreesC);
}

void describe(Fields& f, FanStatus& v) {
  f.nullable("speed_rpm", v.speed_rpm, decimals(0));
  f.required("duty", v.duty, kRatio);
  f.optional("cooling", v.cooling);
}

void describe(Fields& f, OrientationStatus& v) {
  f.required("quaternion", v.quaternion, kUnit);
  f.required("up", v.up, kUnit);
  f.required("rate_deg_s", v.rate_deg_s, decimals(2));
  f.required("age_ms", v.age_ms);
}

void describe(Fields& f, EffectStatus& v) {
  f.required("effect", v.effect);
  f.nullable("slot", v.slot);
  f.required("method", v.method);
  f.required("connection", v.connection);
  f.nullable("client", v.client);
  f.required("priority", v.priority);
  f.required("playing", v.playing);
  f.required("remaining_ms", v.remaining_ms);
  f.required("current_a", v.current_a, kAmps);
}

void describe(Fields& f, LatenessStatus& v) {
  f.required("p50", v.p50, decimals(1));
  f.required("p99", v.p99, decimals(1));
  f.required("max", v.max, decimals(1));
}

void describe(Fields& f, LoopStatus& v) {
  f.required("rate_hz", v.rate_hz, decimals(1));
  f.required("ticks", v.ticks);
  f.required("skipped", v.skipped);
  f.required("lateness_us", v.lateness_us);
}

void describe(Fields& f, LinkStatus& v) {
  f.required("frames_out", v.frames_out);
  f.required("lost", v.lost);
  f.required("errors", v.errors);
}

void describe(Fields& f, Disagreement& v) {
  f.required("coil", v.coil);
  f.required("between", v.between);
}

void describe(Fields& f, TripStatus& v) {
  f.required("reason", v.reason);
  f.required("time_ns", v.time_ns);
  f.nullable("temperature_c", v.temperature_c, kDegreesC);
  f.required("current_a", v.current_a, kAmps);
  f.optional("disagreement", v.disagreement);
}

void describe(Fields& f, PinsStatus& v) {
  f.required("force_n", v.force_n, kNewtons);
  f.required("extension_mm", v.extension_mm, kMillimetres);
}

void describe(Fields& f, Status& v) {
  StatusKeys keys = kTelemetryDefault;
  if (!v.pins.empty() || f.has(name(StatusKey::kPins))) keys.add(StatusKey::kPins);
  describe_only(f, v, keys);
}

void describe(Fields& f, Telemetry& v) {
  if (f.reads()) {
    v.keys = {};
    for (std::size_t i = 0; i < kStatusKeyNames.size(); ++i)
      if (f.has(kStatusKeyNames[i])) v.keys.add(static_cast<StatusKey>(i));
  } else {
    v.keys.add(StatusKey::kTimeNs);
  }
  describe_only(f, v.status, v.keys);
}

void describe(Fields& f, EventDelivery& v) {
  f.required("min", v.min, kRatio);
  f.required("mean", v.mean, kRatio);
}

void describe(Fields& f, PastEvent& v) {
  f.required("at", v.at);
  describe(f, v.event);
  f.optional("method", v.method);
  f.optional("client", v.client);
  f.optional("recording", v.recording);
}

void describe(Fields& f, HistoryResult& v) {
  f.required("events", v.events, {.items = EventsHistory::kMaxEvents});
  f.required("more", v.more);
}

void describe(Fields& f, Event& v) {
  f.required("type", v.type);
  f.required("time_ns", v.time_ns);
  f.optional("state", v.state);
  f.optional("effect", v.effect);
  if (v.effect) f.nullable("slot", v.slot);
  f.optional("seq", v.seq);
  if (v.state) {
    f.nullable("reason", v.reason);
    f.nullable("remedy", v.remedy);
  } else {
    f.optional("reason", v.reason);
  }
  if (v.delivered || f.has("delivered")) {
    f.nullable("onset_ns", v.onset_ns);
    f.nullable("offset_ns", v.offset_ns);
    f.optional("delivered", v.delivered);
    f.optional("masked_ms", v.masked_ms);
    f.optional("mixed_ms", v.mixed_ms);
  }
  f.optional("limit_a", v.limit_a, kAmps);
  f.optional("temperature_c", v.temperature_c, kDegreesC);
  f.optional("current_a", v.current_a, kAmps);
  f.optional("disagreement", v.disagreement);
  f.optional("device", v.device);
  f.optional("skipped", v.skipped);
}

}  // namespace hedgehog::protocol

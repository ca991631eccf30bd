// SPDX-License-Identifier: MIT
#include "protocol/values/status.h"

#include "protocol/wire/fields.h"

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
  // Described in the order of the enum, which is that of the object.
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
  required(kLimitA, v.limit_a);
  nullable(kHeadroomS, v.headroom_s, kSeconds);
  nullable(kBurstS, v.burst_s, kSeconds);
  required(kDerating, v.derating);
  // Full resolution of the board's measurements: calibration uses them.
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

void TemperatureStatus::describe(Fields& f) {
  f.nullable("sensor", sensor, kDegreesC);
  f.nullable("model", model, kDegreesC);
  f.required("coils", coils, kDegreesC);
  f.optional("upper", upper, kDegreesC);
  f.optional("core", core, kDegreesC);
  f.optional("sensors", sensors, kDegreesC);
  f.optional("skin", skin, kDegreesC);
  f.nullable("age_ms", age_ms);
  f.optional("thermometer", thermometer, kDegreesC);
}

void FanStatus::describe(Fields& f) {
  f.nullable("speed_rpm", speed_rpm, decimals(0));
  f.required("duty", duty, kRatio);
  f.optional("cooling", cooling);
}

void OrientationStatus::describe(Fields& f) {
  f.required("quaternion", quaternion, kUnit);
  f.required("up", up, kUnit);
  f.required("rate_deg_s", rate_deg_s, decimals(2));
  f.required("age_ms", age_ms);
}

void EffectStatus::describe(Fields& f) {
  f.required("effect", effect);
  f.nullable("slot", slot);
  f.required("method", method);
  f.required("connection", connection);
  f.nullable("client", client);
  f.required("priority", priority);
  f.required("playing", playing);
  f.required("remaining_ms", remaining_ms);
  f.required("current_a", current_a, kAmps);
}

void LatenessStatus::describe(Fields& f) {
  f.required("p50", p50, decimals(1));
  f.required("p99", p99, decimals(1));
  f.required("max", max, decimals(1));
}

void LoopStatus::describe(Fields& f) {
  f.required("rate_hz", rate_hz, decimals(1));
  f.required("ticks", ticks);
  f.required("skipped", skipped);
  f.required("lateness_us", lateness_us);
}

void LinkStatus::describe(Fields& f) {
  f.required("frames_out", frames_out);
  f.required("lost", lost);
  f.required("errors", errors);
}

void TripStatus::describe(Fields& f) {
  f.required("reason", reason);
  f.required("time_ns", time_ns);
  f.nullable("temperature_c", temperature_c, kDegreesC);
  f.required("current_a", current_a, kAmps);
  f.optional("disagreement", disagreement);
}

void describe(Fields& f, model::PinMotion& v) {
  f.required("force_n", v.force_n, kNewtons);
  f.required("extension_mm", v.extension_mm, kMillimetres);
}

void Status::describe(Fields& f) {
  StatusKeys keys = kTelemetryDefault;
  if (pins != model::PinMotion{} || f.has(name(StatusKey::kPins))) keys.add(StatusKey::kPins);
  describe_only(f, *this, keys);
}

void Telemetry::describe(Fields& f) {
  if (f.reads()) {
    keys = {};
    for (std::size_t i = 0; i < kStatusKeyNames.size(); ++i)
      if (f.has(kStatusKeyNames[i])) keys.add(static_cast<StatusKey>(i));
  } else {
    keys.add(StatusKey::kTimeNs);
  }
  describe_only(f, status, keys);
}

}  // namespace hedgehog::protocol

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/wall_time.h"
#include "protocol/describe.h"

namespace hedgehog::protocol {
namespace {

constexpr Spec kEffectNumber{.min = 1};

void exactly_one(Fields& f, bool effect, bool slot) {
  if (effect && slot)
    f.fail(invalid_params("slot", "effect is said too; say only one of effect and slot"));
  else if (!effect && !slot)
    f.fail(invalid_params("effect", "is missing; say effect or slot"));
}

/// Clients round quaternions; what is off by more than that is a mistake.
void normalise(Fields& f, std::string_view field, model::Quaternion& q) {
  constexpr double kTolerance = 0.01;
  const double length = model::norm(q);
  if (!(std::fabs(length - 1.0) <= kTolerance)) {
    RpcError error = invalid_params(field, "is not of length 1");
    error.limit = std::int64_t{1};
    error.value = length;
    f.fail(std::move(error));
    return;
  }
  constexpr double kExact = 1e-12;
  if (std::fabs(length - 1.0) > kExact)
    q = {q.w / length, q.x / length, q.y / length, q.z / length};
}

void check_known(Fields& f, const std::vector<std::string>& types) {
  const Names known = kEventTypes;
  for (const std::string& type : types) {
    if (std::find(known.begin(), known.end(), type) == known.end()) {
      RpcError error = invalid_params(
          "types", "there is no event '" + shortened(type) + "'" + hint(type, known));
      error.value = shortened(type);
      f.fail(std::move(error));
    }
  }
}

std::vector<StatusKey> listed(StatusKeys keys) {
  std::vector<StatusKey> list;
  for (std::size_t i = 0; i < kStatusKeyNames.size(); ++i)
    if (keys.contains(static_cast<StatusKey>(i))) list.push_back(static_cast<StatusKey>(i));
  return list;
}

StatusKeys as_set(const std::vector<StatusKey>& list) {
  StatusKeys keys;
  for (const StatusKey key : list) keys.add(key);
  return keys;
}

/// A start that is only talked about: `method` names it, `params` are its parameters.
void method_and_params(Fields& f, std::optional<EffectStart>& start) {
  std::optional<model::EffectMethod> method;
  if (start) method = effect_of(start->method);
  f.optional("method", method);
  if (method && !start) start.emplace(EffectStart{.method = method_of(*method)});
  const bool has_params = f.has("params");
  if (f.checks() && !method && has_params)
    f.fail(invalid_params("method", "is missing beside params"));
  f.optional("params", start);
  if (f.checks() && start && !has_params)
    f.fail(invalid_params("params", "is missing beside method"));
}

}  // namespace

void describe(Fields& f, Hello& v) {
  constexpr Spec kClient{.max = 128};
  f.defaulted("client", v.client, kClient, !v.client.empty());
  f.defaulted("protocol", v.protocol, {.max = 16}, !v.protocol.empty());
  f.optional("token", v.token, {.min = 1, .max = 256});
  if (f.checks() && !v.protocol.empty() && v.protocol != "1" && !v.protocol.starts_with("1.")) {
    RpcError error{.code = ErrorCode::kUnsupported,
                   .message = "protocol: this server speaks 1.0 to 1.x, not " + v.protocol};
    error.field = "protocol";
    error.limit = "1.x";
    error.value = v.protocol;
    f.fail(std::move(error));
  }
}

void describe(Fields& f, EffectStart& v) { describe(f, v.params, v.method); }

void describe(Fields& f, EffectUpdate& v) {
  f.optional("effect", v.effect, kEffectNumber);
  describe(f, v.params, Method::kEffectUpdate);
  if (f.checks()) exactly_one(f, v.effect.has_value(), v.params.slot.has_value());
}

void describe(Fields& f, EffectStop& v) {
  f.optional("effect", v.effect, kEffectNumber);
  f.optional("slot", v.slot, {.min = 1, .max = kMaxSlotCharacters});
  if (f.checks()) exactly_one(f, v.effect.has_value(), v.slot.has_value());
}

void describe(Fields& f, EffectStopAll& v) { f.defaulted("scope", v.scope); }

void describe(Fields& f, EffectPreview& v) {
  method_and_params(f, v.start);
  if (f.checks() && !v.start)
    f.fail(invalid_params("method", "is missing; for example \"effect.pulse\""));
}

void describe(Fields& f, DeviceClaim& v) {
  f.defaulted("lease_ms", v.lease_ms, {.min = kMinLeaseMs, .max = kMaxLeaseMs, .rounded = true});
}

void describe(Fields& f, OutputSetGain& v) { f.required("gain", v.gain, {.min = 0, .max = 1}); }

void describe(Fields& f, ThermalForecast& v) {
  f.optional("current_a", v.current_a, {.min = 0});
  f.optional("direction", v.direction);
  method_and_params(f, v.start);
  f.optional("effect", v.effect, kEffectNumber);
  if (!f.checks()) return;
  const int given = (v.current_a ? 1 : 0) + (v.start ? 1 : 0) + (v.effect ? 1 : 0);
  if (given != 1) {
    f.fail(invalid_params(given == 0 ? "current_a"
                          : v.effect ? "effect"
                                     : "method",
                          "say exactly one of current_a, method with params, and effect"));
  }
  if (v.direction && !v.current_a) f.fail(invalid_params("direction", "goes with current_a only"));
}

void describe(Fields& f, OrientationSet& v) {
  f.required("quaternion", v.quaternion);
  if (f.checks()) normalise(f, "quaternion", v.quaternion);
}

void describe(Fields& f, OrientationRecenter& v) {
  f.defaulted("azimuth_deg", v.azimuth_deg, {.min = -360, .max = 360});
}

void describe(Fields& f, TelemetrySubscribe& v) {
  f.defaulted("rate_hz", v.rate_hz, {.min = 0.1, .max = 200});
  std::vector<StatusKey> list = listed(v.fields);
  f.defaulted("fields", list, {}, v.fields != kTelemetryDefault);
  v.fields = as_set(list);
  if (f.checks() && v.fields.empty())
    f.fail(invalid_params("fields", "the list is empty; leave it out for all but pins"));
}

void describe(Fields& f, TelemetryResult& v) {
  f.required("rate_hz", v.rate_hz);
  std::vector<StatusKey> list = listed(v.fields);
  f.required("fields", list);
  v.fields = as_set(list);
}

void describe(Fields& f, EventsSubscribe& v) {
  f.defaulted("types", v.types, {}, !v.types.empty());
  f.defaulted("scope", v.scope);
  if (f.checks()) check_known(f, v.types);
}

void describe(Fields& f, EventsHistory& v) {
  f.optional("since", v.since, {.min = 1, .max = 40});
  f.defaulted("types", v.types, {}, !v.types.empty());
  f.defaulted("trips", v.trips);
  f.defaulted("limit", v.limit, {.min = 1, .max = EventsHistory::kMaxEvents});
  if (!f.checks()) return;
  check_known(f, v.types);
  if (v.since && !base::parse_rfc3339(*v.since)) {
    RpcError error = invalid_params("since", "must be a time like 2026-11-20T23:14:07Z (RFC 3339)");
    error.value = *v.since;
    f.fail(std::move(error));
  }
}

void describe(Fields& f, SimFault& v) {
  f.defaulted("faults", v.faults);
  f.defaulted("coil", v.coil, {.min = 0, .max = 2});
}

void describe(Fields& f, SimError& v) {
  f.required("kind", v.kind, {.min = 1, .max = 40});
  f.optional("coil", v.coil, {.min = 0, .max = 2});
  f.required("value", v.value);
  f.defaulted("ramp_s", v.ramp_s, {.min = 0, .max = 86400});
}

void describe(Fields&, SimTruth&) {}

void describe(Fields& f, SimSet& v) {
  f.optional("orientation", v.orientation);
  f.optional("ambient_c", v.ambient_c, {.min = -20, .max = 60});
  f.optional("fault", v.fault);
  f.optional("errors", v.errors, {.items = kMaxSimErrors});
  if (f.checks() && v.orientation) normalise(f, "orientation", *v.orientation);
}

void describe(Fields& f, Request& v) {
  std::visit([&](auto& request) { f.value(request); }, v);
}

}  // namespace hedgehog::protocol

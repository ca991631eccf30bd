// SPDX-License-Identifier: MIT
#include "protocol/methods/telemetry.h"

#include <vector>

namespace hedgehog::protocol {
namespace {

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

}  // namespace

void TelemetrySubscribe::describe(Fields& f) {
  f.defaulted("rate_hz", rate_hz, {.min = 0.1, .max = 200});
  std::vector<StatusKey> list = listed(fields);
  f.defaulted("fields", list, {}, fields != kTelemetryDefault);
  fields = as_set(list);
  if (f.checks() && fields.empty())
    f.fail(invalid_params("fields", "the list is empty; leave it out for all but pins"));
}

void TelemetryResult::describe(Fields& f) {
  f.required("rate_hz", rate_hz);
  std::vector<StatusKey> list = listed(fields);
  f.required("fields", list);
  fields = as_set(list);
}

void TelemetrySample::describe(Fields& f) {
  f.required("age_s", age_s, decimals(1));
  f.optional("coils_c", coils_c, decimals(2));
  f.optional("upper_c", upper_c, decimals(2));
  f.optional("sensor_c", sensor_c, decimals(2));
  f.required("current_a", current_a, decimals(2));
  f.required("peak_a", peak_a, decimals(2));
  f.required("limit_a", limit_a, decimals(2));
  f.required("duty", duty, decimals(3));
  f.nullable("headroom_s", headroom_s, decimals(1));
}

void TelemetryHistoryResult::describe(Fields& f) {
  f.required("time_ns", time_ns);
  f.required("step_s", step_s);
  f.required("samples", samples, {.items = static_cast<std::size_t>(kMaxSamples)});
}

void TelemetryHistory::describe(Fields& f) {
  f.defaulted("seconds", seconds, {.min = 1, .max = kMaxSeconds});
}

}  // namespace hedgehog::protocol

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

}  // namespace hedgehog::protocol

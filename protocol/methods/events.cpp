// SPDX-License-Identifier: MIT
#include "protocol/methods/events.h"

#include <algorithm>
#include <utility>

#include "base/wall_time.h"

namespace hedgehog::protocol {
namespace {

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

}  // namespace

void EventsSubscribe::describe(Fields& f) {
  f.defaulted("types", types, {}, !types.empty());
  f.defaulted("scope", scope);
  if (f.checks()) check_known(f, types);
}

void PastEvent::describe(Fields& f) {
  f.required("at", at);
  event.describe(f);
  f.optional("method", method);
  f.optional("client", client);
  f.optional("recording", recording);
  f.optional("count", count);
  f.optional("last", last);
}

void EventsHistory::describe(Fields& f) {
  f.optional("since", since, {.min = 1, .max = 40});
  f.defaulted("types", types, {}, !types.empty());
  f.defaulted("trips", trips);
  f.defaulted("limit", limit, {.min = 1, .max = HistoryResult::kMaxEvents});
  if (!f.checks()) return;
  check_known(f, types);
  if (since && !base::parse_rfc3339(*since)) {
    RpcError error = invalid_params("since", "must be a time like 2026-11-20T23:14:07Z (RFC 3339)");
    error.value = *since;
    f.fail(std::move(error));
  }
}

}  // namespace hedgehog::protocol

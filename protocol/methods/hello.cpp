// SPDX-License-Identifier: MIT
#include "protocol/methods/hello.h"

#include <utility>

namespace hedgehog::protocol {

void Hello::describe(Fields& f) {
  f.defaulted("client", client, {.max = 128}, !client.empty());
  f.defaulted("protocol", protocol, {.max = 16}, !protocol.empty());
  f.optional("token", token, {.min = 1, .max = 256});
  if (f.checks() && !protocol.empty() && protocol != "1" && !protocol.starts_with("1.")) {
    RpcError error{.code = ErrorCode::kUnsupported,
                   .message = "protocol: this server speaks 1.0 to 1.x, not " + protocol};
    error.field = "protocol";
    error.limit = "1.x";
    error.value = protocol;
    f.fail(std::move(error));
  }
}

void HelloDevice::describe(Fields& f) {
  f.required("name", name);
  f.required("model", model);
  f.required("simulated", simulated);
}

void HelloLimits::describe(Fields& f) {
  f.required("current_a", current_a);
  f.required("continuous_a", continuous_a);
  f.required("felt_a", felt_a);
  f.required("duration_ms", duration_ms);
  f.required("lease_ms", lease_ms);
  f.required("effects", effects);
  f.required("frequency_hz", frequency_hz);
  f.required("telemetry_hz", telemetry_hz);
  f.required("line_bytes", line_bytes);
  f.optional("burst_s", burst_s, decimals(1));
}

void HelloResult::describe(Fields& f) {
  f.required("server", server);
  f.required("version", version);
  f.required("protocol", protocol);
  f.required("connection", connection);
  f.required("start_id", start_id);
  f.required("role", role);
  f.required("state", state);
  f.nullable("reason", reason);
  f.nullable("remedy", remedy);
  f.required("methods", methods);
  f.required("device", device);
  f.required("limits", limits);
}

}  // namespace hedgehog::protocol

// SPDX-License-Identifier: MIT
// A field that is held, and what telemetry has of the pins meanwhile.
#pragma once

#include "tests/server/server_rig.h"

namespace hedgehog::server {

/// What telemetry says of the pins now.
inline Json pins_now(ServerRig& rig, FakeClient& client) {
  rig.call(client, "telemetry.subscribe", {{"rate_hz", 200}, {"fields", {"pins"}}});
  rig.on_event(client, LineKind::kTelemetry);
  rig.run(10);
  return rig.on_event(client, LineKind::kTelemetry).back()["pins"];
}

inline void hold(ServerRig& rig, FakeClient& client, const Json& direction, double current_a) {
  rig.call(client, "effect.hold",
           {{"direction", direction}, {"current_a", current_a}, {"lease_ms", 10000}});
  rig.run(100);
}

}  // namespace hedgehog::server

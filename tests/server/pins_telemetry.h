// SPDX-License-Identifier: MIT
// A constant field, and the pins in its telemetry.
#pragma once

#include "tests/server/server_rig.h"

namespace hedgehog::server {

/// The pins in the next telemetry.
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

// SPDX-License-Identifier: MIT
// A daemon's results for the study's requests, by method.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace hedgehog::study {

/// `start_id` empty: an older daemon, which reports none.
inline nlohmann::json fake_responses(const std::string& start_id = "") {
  auto responses = nlohmann::json::parse(R"({
  "hello": {"server": "hedgehogd", "version": "1", "protocol": "1.0", "connection": 1,
    "role": "operate", "state": "armed", "reason": null, "remedy": null, "methods": [],
    "device": {"name": "ball", "model": "hedgehog-86", "simulated": true},
    "limits": {"current_a": 15, "continuous_a": 5, "felt_a": 2.1, "duration_ms": 10000,
      "lease_ms": 10000, "effects": 32, "frequency_hz": 250, "telemetry_hz": 200,
      "line_bytes": 65536}},
  "device.describe": {"name": "ball", "model": "hedgehog-86", "simulated": true,
    "arrangement": "tkD-86", "pins": [], "gain": 1, "calibration": {"force_n_per_a": 0.0126},
    "coils": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "r25_ohm": [0.45, 0.45, 0.45],
      "inductance_h": 0.0015, "supply_v": 12},
    "limits": {"current_a": 15, "continuous_a": 5, "felt_a": 2.1, "derate_from_c": 60,
      "sustain_c": 67, "zero_c": 69, "trip_c": 70, "rearm_c": 45},
    "board": {"backend": "simulator", "present": true, "serial": null, "firmware": null},
    "imu": {"type": "none", "present": false}},
  "events.subscribe": {"state": "armed", "reason": null, "derating": false, "limit_a": 15},
  "telemetry.subscribe": {"rate_hz": 5, "fields": ["time_ns"]},
  "device.claim": {"lease_ms": 10000},
  "effect.circle": {"effect": 7, "slot": null, "accepted": true, "limited_by": null,
    "current_a": 5, "force_n": 0.06, "pin": 46, "headroom_s": null, "seq": 1,
    "period_ms": 1500},
  "device.status": {"state": "armed", "reason": null, "derating": false},
  "thermal.forecast": {"seconds_to_derating": null}
})");
  if (!start_id.empty()) responses["hello"]["start_id"] = start_id;
  return responses;
}

}  // namespace hedgehog::study

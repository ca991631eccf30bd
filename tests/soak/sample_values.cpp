// SPDX-License-Identifier: MIT
#include "tests/soak/sample_values.h"

#include <map>

namespace hedgehog::soak {

const std::vector<std::string>& sample_texts(std::string_view name) {
  static const std::vector<std::string> patterns{"heartbeat", "tick",     "alarm",   "soak/one",
                                                 "soak/two",  "soak/3.x", "no/such", "nothing"};
  static const std::map<std::string, std::vector<std::string>, std::less<>> all{
      {"slot", {"a", "b", "engine", "Bäume", "🦔", "with \\ and \"", std::string(32, 'x'), "c"}},
      {"pattern", patterns},
      {"name", patterns},
      {"types",
       {"effect_started", "effect_ended", "state_changed", "derating_started", "derating_ended",
        "measurement_accepted", "measurement_rejected", "orientation_lost", "orientation_restored",
        "overrun"}},
      {"faults",
       {"sensor_open", "sensor_short", "sensor_frozen", "sensor_jump", "sensor_stale",
        "stuck_bridge", "bridge_fault", "open_winding", "fan_stopped", "silent", "supply_low",
        "current_sense", "sensor_offset", "no_such"}},
      {"kind",
       {"current_gain", "current_offset_a", "supply_gain", "resistance_gain", "thermistor_contact",
        "cooling_gain", "heat_capacity_gain", "no_such_kind"}},
      {"since",
       {"2026-11-20T23:14:07Z", "1970-01-01T00:00:00Z", "2999-12-31T23:59:59.5+01:00",
        "yesterday"}},
      {"protocol", {"1.0", "1.0", "1.0", "1.7", "7.1"}},
  };
  static const std::vector<std::string> none;
  const auto found = all.find(name);
  return found == all.end() ? none : found->second;
}

const std::vector<std::string>& sample_quaternions() {
  static const std::vector<std::string> all{
      R"({"w":1,"x":0,"y":0,"z":0})", R"({"w":0,"x":1,"y":0,"z":0})",
      R"({"w":0.7071,"x":0,"y":0.7071,"z":0})", R"({"w":0.5,"x":0.5,"y":-0.5,"z":0.5})",
      R"({"w":3,"x":0,"y":0,"z":0})"};
  return all;
}

const std::vector<std::string>& unusual_values() {
  static const std::vector<std::string> all{"null",
                                            "true",
                                            "-1",
                                            "1e308",
                                            "-1e308",
                                            "1e999",
                                            "9007199254740993",
                                            "18446744073709551616",
                                            "-9223372036854775808",
                                            "4294967296",
                                            "-0.0",
                                            "1e-320",
                                            "0.1234567890123456789",
                                            R"("")",
                                            R"("\u0000")",
                                            R"("\ud800")",
                                            R"("💥")",
                                            "[]",
                                            "{}",
                                            "[0,0,0]",
                                            "[1e300,1e300,1e300]",
                                            R"(["up","up"])",
                                            R"({"a":{"b":[1,{"c":null}]}})",
                                            R"({"pin":-1})",
                                            R"({"pin":86})",
                                            R"({"azimuth_deg":361})"};
  return all;
}

const std::vector<std::string>& no_requests() {
  static const std::vector<std::string> all{
      R"({"jsonrpc":"1.0","id":"old","method":"ping"})",
      R"({"id":"bare","method":"ping"})",
      R"({"jsonrpc":"2.0","id":"nothing"})",
      R"({"jsonrpc":"2.0","id":{},"method":"ping"})",
      R"({"jsonrpc":"2.0","id":true,"method":"ping"})",
      R"({"jsonrpc":"2.0","id":9007199254740993,"method":"ping"})",
      R"({"jsonrpc":"2.0","id":"number","method":7})",
      R"({"jsonrpc":"2.0","id":"extra","method":"ping","extra":[{}]})",
      R"("ping")",
      "{}",
      "7",
      "null",
      "[]",
      "[[]]",
      "[1,[2],{}]"};
  return all;
}

}  // namespace hedgehog::soak

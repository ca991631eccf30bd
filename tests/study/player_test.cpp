// SPDX-License-Identifier: MIT
// A daemon that does not keep its word does not hang a run.
#include "clients/study/session/player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/clients/fake_daemon.h"

namespace hedgehog::study {
namespace {

using namespace std::chrono_literals;
using client::FakeDaemon;
using client::FakePeer;
using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kAnswers = R"({
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
    "period_ms": 1500}
})";

/// Answers everything as a daemon does, and plays no circle to its end. After it has begun one it
/// tells the time, `tick_ms` later each time it is asked for anything, or (0) nothing any more.
FakeDaemon::Conversation never_ending(std::int64_t tick_ms) {
  return [tick_ms](FakePeer& peer) {
    const json answers = json::parse(kAnswers);
    std::int64_t time_ns = 1'000'000'000;
    for (std::string line = peer.read(); !line.empty(); line = peer.read()) {
      const json asked = json::parse(line);
      const std::string method = asked["method"];
      if (asked.contains("id")) {
        const json result = method == "ping" ? json{{"time_ns", time_ns}} : answers.at(method);
        peer.send_line(json{{"jsonrpc", "2.0"}, {"id", asked["id"]}, {"result", result}}.dump());
      }
      for (int i = 0; method == "ping" && tick_ms > 0 && i < 10; ++i) {
        time_ns += tick_ms * 1'000'000;
        peer.send_line(
            json{{"jsonrpc", "2.0"}, {"method", "telemetry"}, {"params", {{"time_ns", time_ns}}}}
                .dump());
      }
    }
  };
}

client::Outcome<IntervalPlayed> played_by(
    const FakeDaemon& daemon, const std::function<bool()>& abort = [] { return false; },
    client::Milliseconds silence = 20s) {
  auto player = Player::open({daemon.address()}, 5s, silence);
  if (!player) return player.error();
  return player->play(1, {5.0, 10.0}, Pattern{}, std::nullopt, abort);
}

TEST(Player, ACircleThatNeverEndsIsAnErrorWhenItIsOverdue) {
  const FakeDaemon daemon(never_ending(2'000));
  const auto played = played_by(daemon);
  ASSERT_FALSE(played.has_value());
  EXPECT_THAT(played.error().message, HasSubstr("never said that the circle ended"));
  EXPECT_NE(played.error().failure, client::Failure::kRefused);
}

TEST(Player, ADaemonThatFallsSilentIsAnError) {
  const FakeDaemon daemon(never_ending(0));
  const auto played = played_by(
      daemon, [] { return false; }, 100ms);
  ASSERT_FALSE(played.has_value());
  EXPECT_THAT(played.error().message, HasSubstr("fallen silent"));
  EXPECT_NE(played.error().failure, client::Failure::kRefused);
}

}  // namespace
}  // namespace hedgehog::study

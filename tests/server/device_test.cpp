// SPDX-License-Identifier: MIT
// The ball itself: hello, forecasts, orientation, status, telemetry.
#include <gtest/gtest.h>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

TEST(Device, HelloHasWhatAGameNeedsFirst) {
  ServerRig rig;
  FakeClient& game = rig.connect(protocol::Role::kPlay);
  const Json hello = rig.call(game, "hello", {{"client", "Racer/1.2"}, {"protocol", "1.0"}});
  EXPECT_EQ(hello["server"], "hedgehogd");
  EXPECT_EQ(hello["role"], "play");
  EXPECT_EQ(hello["state"], "armed");
  EXPECT_EQ(hello["device"]["simulated"], true);
  EXPECT_EQ(hello["limits"]["felt_a"], 2.1);
  EXPECT_EQ(rig.call(game, "hello", {{"protocol", "2.0"}})["code"], -32006);
  EXPECT_EQ(rig.call(game, "hello", {{"token", "x"}})["code"], -32003);
  FakeClient& owner = rig.connect();
  const Json list = rig.call(owner, "connection.list")["connections"];
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0]["client"], "Racer/1.2");
  EXPECT_EQ(list[1]["client"], nullptr);
}

TEST(Device, HelloNamesThisStartOfTheDaemon) {
  const auto start_id = [](ServerRig& rig) {
    return rig.call(rig.connect(), "hello")["start_id"].get<std::string>();
  };
  ServerRig rig;
  const std::string first = start_id(rig);
  EXPECT_EQ(first.size(), 16u);
  EXPECT_EQ(first.find_first_not_of("0123456789abcdef"), std::string::npos) << first;
  EXPECT_EQ(start_id(rig), first);
  ServerRig other;
  EXPECT_NE(start_id(other), first);
}

TEST(Device, TheForecastAcceptsCurrentsMethodsAndEffects) {
  ServerRig rig;
  FakeClient& game = rig.connect(protocol::Role::kPlay);
  const Json fifteen =
      rig.call(game, "thermal.forecast", {{"current_a", 15}, {"direction", "left"}});
  EXPECT_NEAR(fifteen["seconds_to_limit"].get<double>(), 29.6, 1.5);
  EXPECT_NEAR(fifteen["seconds_to_derating"].get<double>(), 22.0, 1.5);
  const Json five = rig.call(game, "thermal.forecast", {{"current_a", 5}});
  EXPECT_EQ(five["seconds_to_derating"], nullptr);
  EXPECT_GT(five["sustainable_a"].get<double>(), 5.0);
  // 12 A at a duty of 15 % is 4.65 A rms: sustainable without limit.
  const Json cue{{"direction", "left"},
                 {"current_a", 12},
                 {"frequency_hz", 2},
                 {"on_fraction", 0.15},
                 {"lease_ms", 2000}};
  EXPECT_EQ(rig.call(game, "thermal.forecast",
                     {{"method", "effect.vibrate"}, {"params", cue}})["seconds_to_derating"],
            nullptr);
  const Json playing = rig.call(game, "effect.vibrate", cue);
  EXPECT_EQ(playing["headroom_s"], nullptr);
  EXPECT_EQ(
      rig.call(game, "thermal.forecast", {{"effect", playing["effect"]}})["seconds_to_derating"],
      nullptr);
  EXPECT_EQ(rig.call(game, "thermal.forecast", {{"current_a", 16}})["data"]["limit"], 15);
  EXPECT_EQ(rig.call(game, "thermal.forecast", {{"effect", 999}})["code"], -32002);
}

TEST(Device, ABatchIsLimitedToEightForecastsSoThatAStopIsNotDelayed) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  Json batch = Json::array();
  for (int id = 0; id < 20; ++id) {
    batch.push_back({{"jsonrpc", "2.0"},
                     {"id", id},
                     {"method", "thermal.forecast"},
                     {"params", {{"current_a", 5}}}});
  }
  batch.push_back({{"jsonrpc", "2.0"}, {"id", 20}, {"method", "ping"}});
  for (int round = 0; round < 2; ++round) {
    const Json responses = rig.exchange(game, batch.dump());
    ASSERT_EQ(responses.size(), 21u);
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_EQ(responses[i]["id"], i);
      EXPECT_EQ(responses[i].contains("result"), i < 8) << i;
    }
    EXPECT_EQ(responses[8]["error"]["code"], -32001);
    EXPECT_EQ(responses[8]["error"]["data"]["limit"], 8);
    EXPECT_GE(responses[8]["error"]["data"]["retry_after_ms"], 1);
    EXPECT_TRUE(responses[20].contains("result")) << "what is no forecast is served";
  }
}

TEST(Device, AHotBallReducesOrRefusesAsRequested) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe");
  const Json hold{{"direction", "left"}, {"current_a", 15}, {"lease_ms", 10000}, {"slot", "s"}};
  for (int i = 0; i < 6; ++i) {
    rig.call(game, "effect.hold", hold);
    rig.run(5000);
  }
  const Json reduced = rig.call(game, "effect.hold", hold);
  EXPECT_EQ(reduced["limited_by"], "thermal");
  EXPECT_LT(reduced["current_a"].get<double>(), 14.0);
  EXPECT_EQ(reduced["headroom_s"], 0);
  Json refusing = hold;
  refusing["if_limited"] = "refuse";
  const Json refused = rig.call(game, "effect.hold", refusing);
  EXPECT_EQ(refused["code"], -32007);
  EXPECT_EQ(refused["data"]["field"], "current_a");
  EXPECT_EQ(refused["data"]["value"], 15);
  EXPECT_GT(refused["data"]["retry_after_ms"].get<int>(), 0);
  bool reported = false;
  for (const Json& event : rig.on_event(game))
    reported = reported || event["type"] == "derating_started";
  EXPECT_TRUE(reported);
  EXPECT_EQ(rig.call(game, "device.status")["derating"], true);
}

TEST(Device, RefusalForecastsTheWholeDuration) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.run(100);
  for (int i = 0; i < 3; ++i) {
    rig.call(game, "effect.hold",
             {{"direction", "left"}, {"current_a", 15}, {"lease_ms", 10000}, {"slot", "s"}});
    rig.run(5000);
  }
  rig.call(game, "effect.stop_all");
  rig.run(10);
  const Json shorter{
      {"direction", "left"}, {"current_a", 15}, {"duration_ms", 1000}, {"if_limited", "refuse"}};
  EXPECT_TRUE(rig.call(game, "effect.pulse", shorter).contains("effect"));
  rig.call(game, "effect.stop_all");
  rig.run(10);
  Json longer = shorter;
  longer["duration_ms"] = 10000;
  const Json refused = rig.call(game, "effect.pulse", longer);
  EXPECT_EQ(refused["code"], -32007);
  EXPECT_EQ(refused["data"]["field"], "duration_ms");
}

TEST(Device, MixAndPriorityAreReported) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "effect.hold", {{"direction", "left"}, {"current_a", 12}});
  const Json mixed = rig.call(game, "effect.hold", {{"direction", "left"}, {"current_a", 12}});
  EXPECT_EQ(mixed["limited_by"], "mix");
  EXPECT_NEAR(mixed["current_a"].get<double>(), 7.5, 1e-6);
  const Json below =
      rig.call(game, "effect.hold", {{"direction", "up"}, {"current_a", 3}, {"priority", 2}});
  EXPECT_EQ(below["limited_by"], "priority");
  EXPECT_EQ(below["current_a"], 0);
  rig.call(game, "effect.stop_all");
  EXPECT_EQ(rig.call(game, "output.set_gain", {{"gain", 0.5}})["gain"], 0.5);
  EXPECT_EQ(rig.state_store.gain, 0.5);
  const Json soft = rig.call(game, "effect.pulse", {{"direction", "up"}, {"current_a", 10}});
  EXPECT_EQ(soft["limited_by"], "configuration");
  EXPECT_NEAR(soft["current_a"].get<double>(), 5.0, 1e-6);
}

TEST(Device, TurningTheBallTurnsWorldEffects) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  // Rotated to the left by 90 degrees: the front points to where left was.
  const double h = std::sqrt(0.5);
  rig.call(game, "sim.set", {{"orientation", {{"w", h}, {"x", 0}, {"y", 0}, {"z", h}}}});
  rig.run(20);
  const Json a = rig.call(game, "effect.hold", {{"direction", "left"}, {"frame", "world"}});
  EXPECT_EQ(a["pin"], rig.call(game, "effect.hold", {{"direction", "front"}})["pin"]);
  const Json recentred = rig.call(game, "orientation.recenter", {{"azimuth_deg", 0}});
  EXPECT_NEAR(std::abs(recentred["yaw_offset_deg"].get<double>()), 90.0, 1e-3);
  EXPECT_EQ(rig.call(game, "orientation.set",
                     {{"quaternion", {{"w", 1}, {"x", 0}, {"y", 0}, {"z", 0}}}})["code"],
            -32006);
}

TEST(Device, TheFirstFeederOwnsAnExternalOrientation) {
  config::Config config;
  config.imu = config::ImuType::kExternal;
  ServerRig rig(config);
  FakeClient& feeder = rig.connect();
  FakeClient& other = rig.connect();
  const Json flat{{"quaternion", {{"w", 1}, {"x", 0}, {"y", 0}, {"z", 0}}}};
  EXPECT_EQ(rig.call(other, "orientation.recenter")["code"], -32005);
  EXPECT_EQ(rig.call(feeder, "orientation.set", flat), Json::object());
  EXPECT_EQ(rig.call(other, "orientation.set", flat)["code"], -32009);
  rig.disconnect(feeder);
  EXPECT_EQ(rig.call(other, "orientation.set", flat), Json::object());
}

TEST(Device, AWorldEffectMayFollowTheFirstOrientationInOneBatch) {
  config::Config config;
  config.imu = config::ImuType::kExternal;
  ServerRig rig(config);
  FakeClient& feeder = rig.connect();
  const Json responses = rig.exchange(
      feeder,
      R"([{"jsonrpc":"2.0","id":1,"method":"orientation.set","params":{"quaternion":{"w":1,"x":0,"y":0,"z":0}}},)"
      R"({"jsonrpc":"2.0","id":2,"method":"effect.pulse","params":{"direction":"up","frame":"world"}}])");
  ASSERT_EQ(responses.size(), 2u) << responses;
  EXPECT_TRUE(responses[1].contains("result")) << responses;
}

TEST(Device, TelemetryKeepsItsRateInDeviceTime) {
  ServerRig rig;
  FakeClient& game = rig.connect(protocol::Role::kObserve);
  EXPECT_EQ(rig.call(game, "telemetry.subscribe", {{"rate_hz", 500}})["data"]["limit"], 200);
  rig.call(game, "telemetry.subscribe", {{"rate_hz", 200}, {"fields", {"orientation"}}});
  rig.run(1000);
  const auto on_event = rig.on_event(game, LineKind::kTelemetry);
  EXPECT_NEAR(static_cast<double>(on_event.size()), 200.0, 1.0);
  EXPECT_EQ(on_event[0].size(), 2u);  // time_ns and the requested field
  EXPECT_TRUE(on_event[0].contains("time_ns"));
  rig.call(game, "telemetry.subscribe", {{"rate_hz", 10}, {"fields", {"pins", "pin"}}});
  rig.call(game, "effect.pulse", {{"direction", "left"}});
  rig.run(100);
  const auto whole = rig.on_event(game, LineKind::kTelemetry);
  ASSERT_FALSE(whole.empty());
  EXPECT_EQ(whole.back()["pins"]["force_n"].size(), 86u);
  rig.call(game, "telemetry.unsubscribe");
  rig.on_event(game, LineKind::kTelemetry);
  rig.run(200);
  EXPECT_TRUE(rig.on_event(game, LineKind::kTelemetry).empty());
}

}  // namespace
}  // namespace hedgehog::server

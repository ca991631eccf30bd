// SPDX-License-Identifier: MIT
// Which roles may play which effects, and the errors of rejected requests (protocol/README.md).
#include <gtest/gtest.h>

#include "daemon/server/effects/effect_spec.h"
#include "model/magnets/ball_geometry.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

Json pulse(const Json& more = Json::object()) {
  Json params{{"direction", "left"}, {"duration_ms", 1000}};
  params.update(more);
  return params;
}

// The pitch compares every pin with every other: computed once per ball, not per request.
TEST(Effects, ACircleHasThePitchOfTheBall) {
  constexpr double kPitchDeg = 31.0;
  const SpecFacts facts{{}, 0.0126, model::thesis_ball().array, kPitchDeg};
  const auto params = protocol::with_defaults(model::EffectMethod::kCircle, {});
  const auto spec = make_spec(model::EffectMethod::kCircle, params, facts);
  ASSERT_TRUE(spec.has_value());
  EXPECT_EQ(spec->trajectory.pitch_deg, kPitchDeg);
  ServerRig rig;
  EXPECT_EQ(rig.device_view->pin_pitch_deg(), model::pin_pitch_deg(rig.device_view->array()));
}

TEST(Effects, AStartIsAcceptedAndPlays) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe");
  const Json a = rig.call(game, "effect.pulse", pulse({{"level", 0.62}, {"duration_ms", 180}}));
  EXPECT_EQ(a["effect"], 1);
  EXPECT_EQ(a["accepted"], true);
  EXPECT_EQ(a["limited_by"], nullptr);
  EXPECT_NEAR(a["current_a"].get<double>(), 9.3, 1e-9);
  EXPECT_EQ(a["pin"], 34);  // the pin on the left
  EXPECT_NEAR(a["force_n"].get<double>(), 9.3 * 0.0126, 0.005);
  rig.run(100);
  EXPECT_NEAR(rig.plant_current_a(), 9.3, 0.3);
  rig.run(200);
  EXPECT_LT(rig.plant_current_a(), 0.1);
  const auto events = rig.on_event(game);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0]["type"], "effect_started");
  EXPECT_EQ(events[0]["seq"], a["seq"]);
  EXPECT_EQ(events[1]["type"], "effect_ended");
  EXPECT_EQ(events[1]["reason"], "completed");
  EXPECT_EQ(events[1]["offset_ns"].get<std::int64_t>() - events[1]["onset_ns"].get<std::int64_t>(),
            180'000'000);
}

TEST(Effects, StrengthIsCheckedAgainstTheBall) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const Json current = rig.call(game, "effect.pulse", pulse({{"current_a", 16}}));
  EXPECT_EQ(current["code"], -32602);
  EXPECT_EQ(current["data"]["field"], "current_a");
  EXPECT_EQ(current["data"]["limit"], 15);
  EXPECT_EQ(current["data"]["value"], 16);
  const Json force = rig.call(game, "effect.pulse", pulse({{"force_n", 0.2}}));
  EXPECT_EQ(force["data"]["field"], "force_n");
  EXPECT_NEAR(force["data"]["limit"].get<double>(), 0.189, 1e-4);
  EXPECT_NEAR(rig.call(game, "effect.pulse", pulse({{"force_n", 0.063}}))["current_a"], 5.0, 1e-6);
}

TEST(Effects, PrivilegesNeedTheRole) {
  ServerRig rig;
  FakeClient& player = rig.connect(protocol::Role::kPlay);
  const Json priority = rig.call(player, "effect.pulse", pulse({{"priority", 9}}));
  EXPECT_EQ(priority["code"], -32004);
  EXPECT_EQ(priority["message"], "priority: role play may use 0 to 7; 8 and 9 need operate");
  EXPECT_EQ(rig.call(player, "effect.pulse", pulse({{"frame", "coil"}}))["data"]["role_needed"],
            "operate");
  EXPECT_EQ(rig.call(player, "effect.stop_all", {{"scope", "all"}})["code"], -32004);
  EXPECT_EQ(rig.call(player, "device.arm")["data"]["role_needed"], "operate");
  FakeClient& observer = rig.connect(protocol::Role::kObserve);
  EXPECT_EQ(rig.call(observer, "effect.pulse", pulse())["code"], -32004);
  EXPECT_TRUE(rig.call(observer, "device.status").contains("state"));
  FakeClient& owner = rig.connect();
  EXPECT_EQ(rig.call(owner, "effect.pulse", pulse({{"frame", "coil"}, {"current_a", 6}}))["code"],
            -32602);
}

TEST(Effects, ASlotIsReplacedInOneTickAndBelongsToItsConnection) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  FakeClient& other = rig.connect();
  rig.call(game, "events.subscribe");
  const Json engine{{"slot", "engine"}, {"direction", "back"}, {"lease_ms", 250}};
  const Json first = rig.call(game, "effect.vibrate", engine);
  EXPECT_EQ(first["slot"], "engine");
  rig.run(100);
  const Json second = rig.call(game, "effect.vibrate", engine);
  EXPECT_NE(second["effect"], first["effect"]);
  rig.run(5);
  const auto events = rig.on_event(game);
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[1]["type"] == "effect_ended" ? events[1]["reason"] : events[2]["reason"],
            "replaced");
  EXPECT_EQ(events[1]["time_ns"], events[2]["time_ns"]);
  EXPECT_EQ(rig.call(other, "effect.stop", {{"slot", "engine"}})["code"], -32002);
  EXPECT_EQ(rig.call(other, "effect.stop", {{"effect", second["effect"]}})["code"], -32002);
  EXPECT_EQ(rig.call(game, "effect.stop", {{"slot", "engine"}})["stopped"], 1);
  rig.run(30);
  EXPECT_LT(rig.plant_current_a(), 0.1);
}

TEST(Effects, AnUpdateRenewsTheLeaseAndKeepsTheKindOfEnd) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const Json a = rig.call(game, "effect.hold", {{"direction", "up"}, {"lease_ms", 200}});
  for (int i = 0; i < 5; ++i) {
    rig.run(150);
    EXPECT_EQ(rig.call(game, "effect.update", {{"effect", a["effect"]}, {"current_a", 3}})
                  .value("current_a", 0.0),
              3.0);
  }
  EXPECT_EQ(rig.call(game, "effect.update",
                     {{"effect", a["effect"]}, {"duration_ms", 100}})["data"]["field"],
            "duration_ms");
  rig.run(210);
  EXPECT_EQ(rig.call(game, "effect.update", {{"effect", a["effect"]}})["code"], -32002);
}

TEST(Effects, WhenAConnectionEndsItsEffectsEndAtTheNextTick) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  FakeClient& operators = rig.connect();
  rig.call(operators, "events.subscribe", {{"scope", "all"}});
  rig.call(game, "effect.hold", {{"direction", "up"}, {"lease_ms", 5000}});
  rig.call(game, "effect.pulse", pulse({{"on_close", "finish"}, {"duration_ms", 300}}));
  rig.run(50);
  rig.on_event(operators);
  rig.disconnect(game);
  rig.run(2);
  auto events = rig.on_event(operators);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0]["reason"], "disconnected");
  EXPECT_GT(rig.plant_current_a(), 1.0);
  rig.run(300);
  events = rig.on_event(operators);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0]["reason"], "completed");
  EXPECT_LT(rig.plant_current_a(), 0.1);
}

TEST(Effects, EventsOfOthersAreSentForScopeAllOnly) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  FakeClient& subscriber = rig.connect();
  FakeClient& some = rig.connect();
  rig.call(subscriber, "events.subscribe");
  rig.call(some, "events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  rig.call(game, "effect.pulse", pulse({{"duration_ms", 10}}));
  rig.run(50);
  EXPECT_TRUE(rig.on_event(subscriber).empty());
  EXPECT_EQ(rig.on_event(some).size(), 1u);
}

TEST(Effects, AreLimitedToThirtyTwoEachAndSixtyFourInAll) {
  ServerRig rig;
  FakeClient* games[] = {&rig.connect(), &rig.connect(), &rig.connect()};
  for (int i = 0; i < 32; ++i) {
    EXPECT_TRUE(rig.call(*games[0], "effect.pulse", pulse()).contains("effect")) << i;
    EXPECT_TRUE(rig.call(*games[1], "effect.pulse", pulse()).contains("effect")) << i;
  }
  const Json own = rig.call(*games[0], "effect.pulse", pulse());
  EXPECT_EQ(own["code"], -32001);
  EXPECT_EQ(own["data"]["limit"], 32);
  const Json all = rig.call(*games[2], "effect.pulse", pulse());
  EXPECT_EQ(all["code"], -32001);
  EXPECT_EQ(all["data"]["limit"], 64);
  EXPECT_EQ(rig.call(*games[0], "effect.stop_all")["stopped"], 32);
  EXPECT_TRUE(rig.call(*games[2], "effect.pulse", pulse()).contains("effect"));
}

TEST(Effects, AClaimPreventsOthersFromPlaying) {
  ServerRig rig;
  FakeClient& study = rig.connect();
  FakeClient& game = rig.connect();
  rig.call(game, "effect.hold", {{"direction", "up"}, {"lease_ms", 5000}});
  EXPECT_EQ(rig.call(study, "device.claim", {{"lease_ms", 500}})["lease_ms"], 500);
  rig.run(30);
  EXPECT_LT(rig.plant_current_a(), 0.1);
  const Json refused = rig.call(game, "effect.pulse", pulse());
  EXPECT_EQ(refused["code"], -32009);
  EXPECT_NEAR(refused["data"]["retry_after_ms"].get<double>(), 470, 20);
  EXPECT_TRUE(rig.call(study, "effect.pulse", pulse()).contains("effect"));
  rig.run(500);
  EXPECT_TRUE(rig.call(game, "effect.pulse", pulse()).contains("effect"));
}

TEST(Effects, NothingPlaysOnABallThatIsNotArmed) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const Json stopped = rig.call(game, "device.emergency_stop");
  EXPECT_EQ(stopped["state"], "disarmed");
  EXPECT_EQ(rig.state_store.latch, control::Reason::kEmergencyStop);
  const Json refused = rig.call(game, "effect.pulse", pulse());
  EXPECT_EQ(refused["code"], -32000);
  EXPECT_EQ(refused["data"]["reason"], "emergency_stop");
  EXPECT_NE(refused["message"].get<std::string>().find("hedgehogctl arm"), std::string::npos);
  EXPECT_EQ(rig.call(game, "device.arm")["state"], "armed");
  EXPECT_TRUE(rig.call(game, "effect.pulse", pulse()).contains("effect"));
}

TEST(Effects, AWorldFrameNeedsASensor) {
  config::Config config;
  config.imu = config::ImuType::kNone;
  ServerRig rig(config);
  FakeClient& game = rig.connect();
  const Json refused = rig.call(game, "effect.pulse", pulse({{"frame", "world"}}));
  EXPECT_EQ(refused["code"], -32005);
  EXPECT_EQ(refused["data"]["device"], "imu");
}

TEST(Effects, ABatchIsAppliedInOneTick) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe");
  Json batch = Json::array();
  for (int i = 0; i < 32; ++i)
    batch.push_back({{"jsonrpc", "2.0"}, {"method", "effect.pulse"}, {"params", pulse()}});
  batch.push_back({{"jsonrpc", "2.0"}, {"id", "a"}, {"method", "ping"}});
  batch.push_back({{"jsonrpc", "2.0"}, {"id", "b"}, {"method", "device.arm"}});
  batch.push_back({{"jsonrpc", "2.0"}, {"id", "c"}, {"method", "nonsense"}});
  const Json responses = rig.exchange(game, batch.dump());
  ASSERT_EQ(responses.size(), 3u);
  EXPECT_EQ(responses[0]["id"], "a");
  EXPECT_EQ(responses[1]["id"], "b");
  EXPECT_EQ(responses[2]["error"]["code"], -32601);
  rig.run(5);
  const auto events = rig.on_event(game);
  ASSERT_EQ(events.size(), 32u);
  for (const Json& event : events) EXPECT_EQ(event["time_ns"], events[0]["time_ns"]);
}

// The forecasts in them are computed after the rest of the batch.
TEST(Effects, ABatchIsAnsweredInTheOrderOfItsRequests) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const auto request = [](int id, const char* method, const Json& params) {
    return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}};
  };
  const Json strong = pulse({{"current_a", 12}, {"slot", "engine"}});
  const Json batch{request(1, "effect.pulse", strong), request(2, "ping", Json::object()),
                   request(3, "effect.pulse", strong), request(4, "nonsense", Json::object()),
                   request(5, "effect.update", {{"slot", "engine"}, {"current_a", 1}})};
  const Json responses = rig.exchange(game, batch.dump());
  ASSERT_EQ(responses.size(), batch.size());
  for (std::size_t i = 0; i < batch.size(); ++i) EXPECT_EQ(responses[i]["id"], batch[i]["id"]);
  EXPECT_TRUE(responses[0]["result"]["headroom_s"].is_number());
  EXPECT_EQ(responses[2]["result"]["headroom_s"], responses[0]["result"]["headroom_s"]);
  EXPECT_EQ(responses[4]["result"]["headroom_s"], nullptr);
}

TEST(Effects, AnEndedOneIsNotMixedWithTheNext) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const Json strong{{"direction", "left"}, {"current_a", 12}, {"duration_ms", 50}};
  rig.call(game, "effect.pulse", strong);
  const auto plays = [&rig] { return rig.device_view->now().effects[0].effect == 1; };
  for (int i = 0; i < 10 && !plays(); ++i) rig.run(1);
  ASSERT_TRUE(plays());
  EXPECT_EQ(rig.call(game, "effect.pulse", strong)["limited_by"], "mix");
  rig.run(60);
  // Control continues, and the server sees the ticks, but no event yet.
  rig.call(game, "effect.pulse", strong);
  rig.run_without_pump(80);
  EXPECT_EQ(rig.call(game, "effect.pulse", strong)["limited_by"], nullptr);
}

TEST(Effects, AnUpdateIsCheckedAsAStartIs) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const Json pulse = rig.call(game, "effect.pulse", {{"direction", "up"}, {"duration_ms", 500}});
  const auto update = [&](const char* field, int value) {
    return rig.call(game, "effect.update", {{"effect", pulse["effect"]}, {field, value}});
  };
  EXPECT_EQ(update("fade_ms", 400)["effect"], pulse["effect"]);
  EXPECT_EQ(update("attack_ms", 200)["data"]["field"], "fade_ms") << "600 ms of 500";
  rig.run(10);
  EXPECT_EQ(update("delay_ms", 100)["data"]["field"], "delay_ms") << "it has begun";
}

}  // namespace
}  // namespace hedgehog::server

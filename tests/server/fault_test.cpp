// SPDX-License-Identifier: MIT
// What a client hears when something is wrong with the ball: faults, arming, absence, remedies.
#include <gtest/gtest.h>

#include "daemon/server/remedy.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

TEST(Faults, AFaultTripsWithItsNameAndArmingSaysWhyNot) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.call(owner, "events.subscribe");
  const Json set = rig.call(owner, "sim.set", {{"fault", {{"faults", {"sensor_open"}}}}});
  EXPECT_EQ(set["faults"], Json({"sensor_open"}));
  rig.run(500);
  const Json status = rig.call(owner, "device.status");
  EXPECT_EQ(status["state"], "tripped");
  EXPECT_EQ(status["reason"], "sensor_open");
  EXPECT_EQ(status["temperature_c"]["sensor"], nullptr);
  EXPECT_EQ(status["last_trip"]["reason"], "sensor_open");
  EXPECT_NE(status["remedy"].get<std::string>().find("hedgehogctl arm"), std::string::npos);
  const Json refused = rig.call(owner, "device.arm");
  EXPECT_EQ(refused["code"], -32000);
  EXPECT_EQ(refused["data"]["reason"], "sensor_open");
  const auto events = rig.heard(owner);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events[0]["type"], "state_changed");
  EXPECT_EQ(events[0]["reason"], "sensor_open");
  rig.call(owner, "sim.set", {{"fault", {{"faults", Json::array()}}}});
  rig.run(500);
  EXPECT_EQ(rig.call(owner, "device.arm")["state"], "armed");
  EXPECT_EQ(rig.call(owner, "sim.set", {{"fault", {{"faults", {"gremlins"}}}}})["code"], -32602);
}

TEST(Faults, AnOldReadingIsNullAndItsAgeGrows) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  const auto temperature = [&] { return rig.call(owner, "device.status")["temperature_c"]; };
  EXPECT_LE(temperature()["age_ms"], 20);
  rig.call(owner, "sim.set", {{"fault", {{"faults", {"sensor_stale"}}}}});
  rig.run(700);
  EXPECT_EQ(temperature()["sensor"], nullptr);
  EXPECT_NEAR(temperature()["age_ms"], 705, 15);
}

TEST(Faults, TheBoardGuardsTheLimitsOfTheConfiguration) {
  config::Config config;
  config.limits.current_a = 8.0;
  config.limits.trip_c = 62.0;
  ServerRig rig(config);
  EXPECT_DOUBLE_EQ(rig.machine->now().board.limit_current_a, 8.8);
  EXPECT_DOUBLE_EQ(rig.machine->now().board.limit_sensor_c, 67.0);
  config.limits.current_a = 6.0;
  rig.machine->set_config(config);
  rig.run(5);
  EXPECT_DOUBLE_EQ(rig.machine->now().board.limit_current_a, 6.6);
  ServerRig usual;
  EXPECT_DOUBLE_EQ(usual.machine->now().board.limit_current_a, 16.5);
  EXPECT_DOUBLE_EQ(usual.machine->now().board.limit_sensor_c, 75.0);
}

TEST(Faults, ABallThatIsGoneIsAbsent) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.call(owner, "effect.hold", {{"direction", "left"}, {"current_a", 8}, {"lease_ms", 10000}});
  rig.run(100);
  EXPECT_NEAR(rig.call(owner, "device.status")["current_a"][1], 8.0, 0.2);
  rig.call(owner, "sim.set", {{"fault", {{"faults", {"silent"}}}}});
  rig.run(500);
  const Json status = rig.call(owner, "device.status");
  EXPECT_EQ(status["state"], "absent");
  EXPECT_EQ(status["current_a"], Json({0.0, 0.0, 0.0})) << "what was measured once is not so now";
  EXPECT_EQ(status["duty"], Json({0.0, 0.0, 0.0}));
  EXPECT_EQ(status["fan"]["speed_rpm"], nullptr);
  const Json refused = rig.call(owner, "effect.hold", {{"direction", "up"}});
  EXPECT_EQ(refused["code"], -32005);
  EXPECT_EQ(refused["data"]["device"], "board");
  EXPECT_EQ(rig.call(owner, "device.arm")["code"], -32005);
}

TEST(Faults, EveryReasonHasARemedyWithACommand) {
  using control::Reason;
  for (int i = 0; i <= static_cast<int>(Reason::kInternal); ++i) {
    const auto reason = static_cast<Reason>(i);
    const auto text = remedy(control::State::kTripped, reason, {});
    ASSERT_TRUE(text) << control::name(reason);
    EXPECT_NE(text->find("hedgehogctl arm"), std::string::npos) << *text;
  }
  EXPECT_FALSE(remedy(control::State::kArmed, Reason::kNone, {}));
  EXPECT_NE(remedy(control::State::kAbsent, Reason::kNoBoard, {})->find("hedgehogd --simulate"),
            std::string::npos);
  EXPECT_NE(remedy(control::State::kTripped, Reason::kOverheated, {45.0, false})->find("45 °C"),
            std::string::npos);
}

TEST(Faults, AnAnswerThatTakesATickReachesAClientThatSaysNoMore) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  const char* stop = R"({"jsonrpc":"2.0","id":1,"method":"device.emergency_stop"})";
  rig.server->line(owner.session, stop);
  rig.disconnect(owner);
  EXPECT_TRUE(owner.lines.empty());
  EXPECT_FALSE(owner.finished);
  rig.run(5);
  ASSERT_EQ(owner.lines.size(), 1u);
  EXPECT_EQ(Json::parse(owner.lines[0].text)["result"]["state"], "disarmed");
  EXPECT_TRUE(owner.finished);
  EXPECT_EQ(rig.server->connections(), 0u);
}

TEST(Faults, WhoIsGoneBeforeItsAnswerIsForgotten) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.server->line(owner.session, R"({"jsonrpc":"2.0","id":1,"method":"device.emergency_stop"})");
  rig.disconnect(owner);
  rig.server->forget(owner.session);
  owner.session.sink = nullptr;
  EXPECT_EQ(rig.server->connections(), 0u);
  rig.run(5);
  EXPECT_TRUE(owner.lines.empty());
  EXPECT_FALSE(owner.finished);
}

}  // namespace
}  // namespace hedgehog::server

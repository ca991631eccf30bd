// SPDX-License-Identifier: MIT
// Responses and events when the ball has a problem: faults, arming, absence, remedies.
#include <gtest/gtest.h>

#include "daemon/server/device/remedy.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

TEST(Faults, AFaultTripsWithItsNameAndArmingReturnsTheReason) {
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
  const auto events = rig.on_event(owner);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events[0]["type"], "state_changed");
  EXPECT_EQ(events[0]["reason"], "sensor_open");
  rig.call(owner, "sim.set", {{"fault", {{"faults", Json::array()}}}});
  rig.run(500);
  EXPECT_EQ(rig.call(owner, "device.arm")["state"], "armed");
  EXPECT_EQ(rig.call(owner, "sim.set", {{"fault", {{"faults", {"gremlins"}}}}})["code"], -32602);
}

TEST(Faults, WithoutATemperatureNothingIsForecast) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  EXPECT_EQ(rig.call(owner, "thermal.forecast", {{"current_a", 5}})["temperature_known"], true);
  rig.call(owner, "sim.set", {{"fault", {{"faults", {"sensor_open"}}}}});
  rig.run(500);
  const Json status = rig.call(owner, "device.status");
  ASSERT_EQ(status["state"], "tripped");
  ASSERT_EQ(status["temperature_c"]["model"], nullptr);
  EXPECT_EQ(status["headroom_s"], 0.0) << "not for ever";
  EXPECT_EQ(status["burst_s"], 0.0);
  const Json unknown{{"seconds_to_derating", 0.0},
                     {"seconds_to_limit", nullptr},
                     {"sustainable_a", 0.0},
                     {"recovery_s", nullptr},
                     {"temperature_known", false}};
  const Json pulse{{"method", "effect.pulse"}, {"params", {{"direction", "left"}}}};
  EXPECT_EQ(rig.call(owner, "thermal.forecast", {{"current_a", 5}}), unknown);
  EXPECT_EQ(rig.call(owner, "thermal.forecast", {{"current_a", 5}, {"direction", "left"}}),
            unknown);
  EXPECT_EQ(rig.call(owner, "thermal.forecast", pulse), unknown);
  EXPECT_EQ(rig.call(owner, "thermal.forecast", {{"current_a", 99}})["data"]["limit"], 15);
  EXPECT_EQ(rig.call(owner, "effect.preview", pulse)["data"]["reason"], "sensor_open");
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

TEST(Faults, TheBoardEnforcesTheLimitsOfTheConfiguration) {
  config::Config config;
  config.limits.current_a = 8.0;
  config.limits.trip_c = 62.0;
  ServerRig rig(config);
  EXPECT_DOUBLE_EQ(rig.device_view->now().board.limit_current_a, 8.8);
  EXPECT_DOUBLE_EQ(rig.device_view->now().board.limit_sensor_c, 67.0);
  config.limits.current_a = 6.0;
  rig.device_view->set_config(config);
  rig.run(5);
  EXPECT_DOUBLE_EQ(rig.device_view->now().board.limit_current_a, 6.6);
  EXPECT_FALSE(rig.device_view->is_board_limited());
  config.limits.current_a = 8.0;
  rig.device_view->set_config(config);
  rig.run(5);
  EXPECT_TRUE(rig.device_view->is_board_limited()) << "until its power-up";
  ServerRig usual;
  EXPECT_DOUBLE_EQ(usual.device_view->now().board.limit_current_a, 16.5);
  EXPECT_DOUBLE_EQ(usual.device_view->now().board.limit_sensor_c, 75.0);
}

TEST(Faults, ATripIsRecordedWithItsValuesAndClients) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "hello", {{"client", "Racer/1.2"}});
  rig.call(game, "effect.hold", {{"direction", "left"}, {"current_a", 5}, {"lease_ms", 9000}});
  rig.run(100);
  rig.call(game, "sim.set", {{"fault", {{"faults", {"sensor_open"}}}}});
  rig.run(200);
  const Json states = rig.call(game, "events.history", {{"types", {"state_changed"}}})["events"];
  ASSERT_FALSE(states.empty());
  const Json& trip = states.back();
  EXPECT_EQ(trip["state"], "tripped");
  EXPECT_EQ(trip["reason"], "sensor_open");
  EXPECT_EQ(trip["client"], "Racer/1.2");
  EXPECT_EQ(trip["method"], "effect.hold");
  EXPECT_NEAR(trip["current_a"].get<double>(), 5.0, 0.5);
  EXPECT_NEAR(trip["temperature_c"].get<double>(), 25.0, 2.0);
  EXPECT_FALSE(trip.contains("recording")) << "nobody records here";
  EXPECT_NE(rig.history_lines.find("sensor_open"), std::string::npos) << "trips at once";
  const Json ends = rig.call(game, "events.history", {{"types", {"effect_ended"}}})["events"];
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_EQ(ends[0]["method"], "effect.hold");
  EXPECT_EQ(ends[0]["reason"], "tripped");
}

TEST(Faults, ABoardThatFallsSilentUnderCurrentIsATripAndItsLatchIsCountedOnce) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.call(owner, "events.subscribe");
  rig.call(owner, "effect.hold", {{"direction", "left"}, {"lease_ms", 10000}});
  rig.run(100);
  const auto silent = [&](const Json& faults) {
    rig.call(owner, "sim.set", {{"fault", {{"faults", faults}}}});
    rig.run(500);
  };
  const auto& trips = rig.server->counters().trips;
  silent({"silent"});
  EXPECT_EQ(trips.at("telemetry_lost"), 1);
  const Json events = rig.call(owner, "events.history", {{"types", {"state_changed"}}})["events"];
  EXPECT_EQ(events.back()["state"], "absent");
  EXPECT_NEAR(events.back()["current_a"].get<double>(), 5.0, 0.5) << "what it ended";
  EXPECT_EQ(events.back()["method"], "effect.hold");

  silent(Json::array());
  rig.call(owner, "device.arm");
  silent({"sensor_open"});
  EXPECT_EQ(trips.at("sensor_open"), 1);
  silent({"sensor_open", "silent"});
  EXPECT_EQ(rig.call(owner, "device.status")["state"], "absent");
  silent({"sensor_open"});
  EXPECT_EQ(rig.call(owner, "device.status")["state"], "tripped");
  EXPECT_EQ(trips.at("sensor_open"), 1) << "the latch that was there";
}

TEST(Faults, ADisconnectedBallIsAbsent) {
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
  EXPECT_EQ(remedy(control::State::kTripped, Reason::kOverheated, {.contradicted = true}),
            "Have the winding and the sensors that the trip names checked; let the ball cool below "
            "45 °C, then run: hedgehogctl arm");
  EXPECT_NE(remedy(control::State::kTripped, Reason::kOverheated, {45.0, false})->find("45 °C"),
            std::string::npos);
}

TEST(Faults, AnEmergencyStopIsAnsweredWhenItsLatchIsOnDiskAndStopsBeforeThat) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.call(owner, "effect.hold", {{"direction", "left"}, {"current_a", 5}, {"lease_ms", 5000}});
  rig.run(100);
  rig.state_store.persisted = Persisted::kPending;
  rig.server->line(owner.session, R"({"jsonrpc":"2.0","id":1,"method":"device.emergency_stop"})");
  rig.run(50);
  EXPECT_LT(rig.plant_current_a(), 0.1);
  EXPECT_TRUE(owner.lines.empty());
  rig.state_store.persisted = Persisted::kYes;
  rig.run(1);
  ASSERT_EQ(owner.lines.size(), 1u);
  const Json result = Json::parse(owner.lines[0].text)["result"];
  EXPECT_EQ(result["state"], "disarmed");
  EXPECT_EQ(result["on_disk"], true);
}

TEST(Faults, AnEmergencyStopReportsALatchThatIsNotPersisted) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.state_store.persisted = Persisted::kNo;
  const Json result = rig.call(owner, "device.emergency_stop");
  EXPECT_EQ(result["state"], "disarmed");
  EXPECT_EQ(result["on_disk"], false);
  EXPECT_FALSE(rig.call(owner, "device.arm").contains("on_disk")) << "of a stop only";
}

TEST(Faults, ADelayedResponseReachesAHalfClosedClient) {
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

TEST(Faults, TheResponseToADisconnectedClientIsDropped) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.server->line(owner.session, R"({"jsonrpc":"2.0","id":1,"method":"device.emergency_stop"})");
  rig.disconnect(owner);
  rig.server->drop_responses(owner.session);
  owner.session.sink = nullptr;
  EXPECT_EQ(rig.server->connections(), 0u);
  rig.run(5);
  EXPECT_TRUE(owner.lines.empty());
  EXPECT_FALSE(owner.finished);
}

std::string batch(std::size_t count, const std::string& method, bool with_ids) {
  Json requests = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    Json request{{"jsonrpc", "2.0"}, {"method", method}};
    if (with_ids) request["id"] = i;
    requests.push_back(std::move(request));
  }
  return requests.dump();
}

TEST(Faults, ABatchMayRequestEightAndANotificationNone) {
  ServerRig rig;
  for (int i = 1; i <= 5'000; ++i)
    rig.history.record({.type = "derating_ended", .time_ns = i}, i, nullptr);
  FakeClient& client = rig.connect(protocol::Role::kObserve);
  const Json responses = rig.exchange(client, batch(64, "events.history", true));
  ASSERT_EQ(responses.size(), 64u);
  for (std::size_t i = 0; i < responses.size(); ++i)
    EXPECT_EQ(responses[i].contains("result"), i < 8) << i;
  EXPECT_EQ(responses[8]["error"]["code"], -32001);
  EXPECT_EQ(responses[8]["error"]["data"]["limit"], 8);
  const auto count_before = rig.server->counters().requests;
  rig.server->line(client.session, batch(64, "events.history", false));
  EXPECT_EQ(rig.server->counters().requests, count_before) << "nobody reads it";
}

TEST(Faults, RequestsDuringAShutdownAreRefusedAndAStopStillLatches) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.server->announce_shutdown("stop");
  const std::map<std::string, Json> requests{{"effect.pulse", {{"direction", "left"}}},
                                             {"output.set_gain", {{"gain", 0.5}}},
                                             {"ping", Json::object()}};
  for (const auto& [method, params] : requests) {
    const Json refused = rig.call(game, method, params);
    EXPECT_EQ(refused["message"], "busy: the daemon is stopping") << method;
    EXPECT_EQ(refused["data"]["retry_after_ms"], 1000);
  }
  rig.run(10);
  EXPECT_LT(rig.plant_current_a(), 0.1);
  EXPECT_EQ(rig.state_store.gain, -1.0);
  game.lines.clear();
  rig.server->line(game.session,
                   R"({"jsonrpc":"2.0","id":"stop","method":"device.emergency_stop"})");
  EXPECT_EQ(rig.state_store.latch, control::Reason::kEmergencyStop);
  ASSERT_EQ(game.lines.size(), 1u) << "no tick comes any more that the answer could wait for";
  const Json stopped = Json::parse(game.lines.front().text);
  EXPECT_EQ(stopped["id"], "stop");
  EXPECT_EQ(stopped["result"]["state"], "disarmed");
  EXPECT_EQ(stopped["result"]["reason"], "emergency_stop");
  EXPECT_EQ(stopped["result"]["remedy"], "Run: hedgehogctl arm");
  EXPECT_FALSE(rig.server->has_pending());
}

}  // namespace
}  // namespace hedgehog::server

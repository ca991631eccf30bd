// SPDX-License-Identifier: MIT
// Injected errors of the simulator: responses, measurements, and events for clients.
#include <gtest/gtest.h>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

TEST(SimErrors, ActOnMeasurementsAndNotOnTheTrueState) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  const Json set =
      rig.call(owner, "sim.set",
               {{"errors",
                 {{{"kind", "thermistor_offset_k"}, {"value", 5.05}},
                  {{"kind", "supply_gain"}, {"value", 0.9}, {"coil", 2}, {"ramp_s", 0.5}}}}});
  EXPECT_EQ(set["errors"][0],
            Json({{"kind", "thermistor_offset_k"}, {"coil", 0}, {"value", 5.05}, {"ramp_s", 0.0}}));
  EXPECT_FALSE(set["errors"][1].contains("coil")) << "it touches no single winding";
  rig.run(1000);
  const Json status = rig.call(owner, "device.status");
  EXPECT_NEAR(status["temperature_c"]["sensor"], 30.05, 1.0);
  EXPECT_NEAR(status["supply_v"], 10.8, 0.1);
  const Json truth = rig.call(owner, "sim.truth");
  EXPECT_NEAR(truth["coils_c"][0], 25.0, 0.01);
  EXPECT_NEAR(truth["skin_c"], 25.0, 0.01);
  EXPECT_EQ(truth["current_a"], Json({0.0, 0.0, 0.0}));
  EXPECT_EQ(rig.call(owner, "sim.set", {{"errors", Json::array()}})["errors"], Json::array());
  rig.run(100);
  EXPECT_NEAR(rig.call(owner, "device.status")["supply_v"], 12.0, 0.1);
}

TEST(SimErrors, OutOfRangeAreRefusedByFieldAndChangeNothing) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  const auto refused = [&](const Json& error) {
    const Json response =
        rig.call(owner, "sim.set", {{"errors", {{{"kind", "tach_gain"}, {"value", 0.5}}, error}}});
    EXPECT_EQ(response["code"], -32602) << response;
    return response["data"]["field"].get<std::string>();
  };
  EXPECT_EQ(refused({{"kind", "gremlins"}, {"value", 1}}), "errors[1].kind");
  EXPECT_EQ(refused({{"kind", "shorted_turns"}, {"value", 0.95}}), "errors[1].value");
  EXPECT_EQ(refused({{"kind", "pwm_stuck"}, {"value", -2}}), "errors[1].value");
  EXPECT_EQ(refused({{"kind", "current_gain"}, {"value", 1}, {"coil", 3}}), "errors[1].coil");
  EXPECT_EQ(rig.call(owner, "sim.set")["errors"], Json::array());
}

TEST(SimErrors, ThatContradictAnotherQuantityAreNamedInEventAndLastTrip) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.call(owner, "events.subscribe");
  const Json left = Json::parse(
      R"([{"t_ms":0,"direction":"left","level":1,"ease":"step"},{"t_ms":8000,"level":0}])");
  const Json playing = rig.call(owner, "effect.play", {{"keyframes", left}, {"current_a", 8}});
  ASSERT_EQ(playing["current_a"], 8.0) << playing;
  rig.run(3000);
  rig.call(owner, "sim.set",
           {{"errors", {{{"kind", "current_gain"}, {"coil", 1}, {"value", 1.15}, {"ramp_s", 0}}}}});
  rig.run(1000);
  const Json named = {{"coil", 1}, {"between", {"current", "supply_current"}}};
  const Json status = rig.call(owner, "device.status");
  EXPECT_EQ(status["reason"], "measurements_disagree");
  EXPECT_EQ(status["last_trip"]["disagreement"], named);
  Json tripped;
  for (const Json& event : rig.on_event(owner))
    if (event["type"] == "state_changed") tripped = event;
  EXPECT_EQ(tripped["reason"], "measurements_disagree");
  EXPECT_EQ(tripped["disagreement"], named);
}

}  // namespace
}  // namespace hedgehog::server

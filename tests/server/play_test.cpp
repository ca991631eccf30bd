// SPDX-License-Identifier: MIT
// effect.play with the real controller and board, as documented in protocol/README.md.
#include <gtest/gtest.h>

#include <vector>

#include "daemon/server/effects/keyframe_track.h"
#include "model/magnets/ball_geometry.h"
#include "tests/server/pattern_examples.h"

namespace hedgehog::server {
namespace {

TEST(Play, TheKeyFramesBecomeCurrents) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe");
  const Json a = rig.call(game, "effect.play", {{"keyframes", kLeft}, {"current_a", 8}});
  EXPECT_EQ(a["current_a"], 4.0) << "the strongest key frame";
  EXPECT_EQ(a["pin"], 34);
  EXPECT_EQ(a["limited_by"], nullptr);
  rig.run(250);
  EXPECT_NEAR(rig.world.board().plant().current_a().y, 4.0, 0.1);
  rig.run(200);
  EXPECT_LT(rig.plant_current_a(), 0.1);
  rig.run(200);
  const auto events = rig.on_event(game);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[1]["reason"], "completed");
  EXPECT_EQ(events[1]["offset_ns"].get<std::int64_t>() - events[1]["onset_ns"].get<std::int64_t>(),
            600'000'000);
  EXPECT_EQ(events[1]["delivered"]["min"], 1.0);
}

TEST(Play, ANamedPatternIsTurnedAndHasItsWaveform) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  Json steady = knock("acme/steady");
  steady["keyframes"] = Json::parse(R"([{"t_ms":0,"level":1},{"t_ms":1000,"level":1}])");
  steady["waveform"] = "square";
  steady["frequency_hz"] = 2;
  rig.call(game, "pattern.put", steady);
  const Json a = rig.call(game, "effect.play", {{"pattern", "acme/steady"}, {"rotate_to", "up"}});
  EXPECT_EQ(a["pin"], 0);
  rig.run(200);
  EXPECT_NEAR(rig.world.board().plant().current_a().z, 5.0, 0.1);
  rig.run(150);
  EXPECT_LT(rig.plant_current_a(), 0.1) << "the square is off";
  rig.call(game, "effect.stop_all");
  rig.call(game, "effect.play", {{"pattern", "acme/steady"}, {"waveform", "constant"}});
  rig.run(400);
  EXPECT_NEAR(rig.world.board().plant().current_a().x, 5.0, 0.1) << "what is said wins";
}

TEST(Play, EveryShippedPatternPlaysToItsEnd) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe", {{"types", {"effect_ended"}}});
  const Json list = rig.call(game, "pattern.list")["patterns"];
  EXPECT_GE(list.size(), 12u);
  for (const Json& pattern : list) {
    EXPECT_EQ(pattern["shipped"], true);
    EXPECT_FALSE(pattern["description"].get<std::string>().empty()) << pattern;
    const Json a = rig.call(game, "effect.play", {{"pattern", pattern["name"]}, {"rate", 2}});
    EXPECT_NEAR(a["current_a"].get<double>(), 5.0, 0.8) << pattern["name"];
    rig.run(pattern["duration_ms"].get<model::Tick>() / 2 + 20);
    const auto ended = rig.on_event(game);
    ASSERT_EQ(ended.size(), 1u) << pattern["name"];
    EXPECT_EQ(ended[0]["reason"], "completed") << pattern["name"];
  }
}

TEST(Play, ALoopEndsByItsLeaseWithItsConnectionAndByAStop) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe");
  const Json loop{{"pattern", "orbit"}, {"loop", true}, {"lease_ms", 500}, {"slot", "way"}};
  rig.call(game, "effect.play", loop);
  rig.run(300);
  EXPECT_GT(rig.plant_current_a(), 4.5);
  rig.call(game, "effect.update", {{"slot", "way"}, {"rate", 3}});
  rig.run(490);
  EXPECT_GT(rig.plant_current_a(), 4.5) << "the update renewed the lease";
  rig.run(40);
  EXPECT_LT(rig.plant_current_a(), 0.1);
  EXPECT_EQ(rig.on_event(game).back()["reason"], "expired");

  FakeClient& other = rig.connect();
  rig.call(other, "effect.play", loop);
  rig.run(100);
  EXPECT_GT(rig.plant_current_a(), 4.5);
  rig.disconnect(other);
  rig.run(30);
  EXPECT_LT(rig.plant_current_a(), 0.1);
}

TEST(Play, AnUpdateMayReplaceKeyFrames) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "effect.play", {{"pattern", "orbit"}, {"loop", true}, {"slot", "a"}});
  rig.run(50);
  EXPECT_NEAR(rig.world.board().plant().current_a().x, 5.0, 0.3);
  const Json up = Json::parse(R"([{"t_ms":0,"direction":"up","level":1},{"t_ms":900,"level":1}])");
  EXPECT_EQ(rig.call(game, "effect.update", {{"slot", "a"}, {"keyframes", up}})["pin"], 0);
  rig.run(50);
  EXPECT_NEAR(rig.world.board().plant().current_a().z, 5.0, 0.1);
  EXPECT_EQ(rig.call(game, "effect.update", {{"slot", "a"}, {"direction", "up"}})["data"]["field"],
            "direction");
  rig.call(game, "effect.hold", {{"direction", "up"}, {"slot", "b"}});
  EXPECT_EQ(rig.call(game, "effect.update", {{"slot", "b"}, {"rate", 2}})["data"]["field"], "rate");
}

TEST(Play, AnUpdateReplacesThePatternCompletely) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  Json buzz = knock("acme/buzz");
  buzz["waveform"] = "square";
  buzz["frequency_hz"] = 2;
  rig.call(game, "pattern.put", buzz);
  const Json steady = Json::parse(R"([{"t_ms":0,"direction":"left","level":1},
                                      {"t_ms":2000,"level":1}])");
  rig.call(game, "pattern.put", {{"name", "acme/steady"}, {"keyframes", steady}});
  rig.call(game, "effect.play", {{"pattern", "acme/buzz"}, {"slot", "a"}, {"duration_ms", 3000}});
  rig.run(10);
  rig.call(game, "effect.update", {{"slot", "a"}, {"pattern", "acme/steady"}});
  rig.run(350);
  EXPECT_NEAR(rig.world.board().plant().current_a().y, 5.0, 0.1) << "no square of 2 Hz any more";

  rig.call(game, "effect.stop_all");
  rig.call(game, "effect.play",
           {{"pattern", "acme/steady"},
            {"slot", "a"},
            {"waveform", "square"},
            {"frequency_hz", 2},
            {"duration_ms", 3000}});
  rig.run(10);
  rig.call(game, "effect.update", {{"slot", "a"}, {"keyframes", steady}});
  rig.run(350);
  EXPECT_LT(rig.plant_current_a(), 0.1) << "what the caller said stays";
}

TEST(Play, APatternIsAdmittedByItsPlayedPart) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  // Full level for 9 s, then silence up to 60 s.
  const Json frames = Json::parse(R"([{"t_ms":0,"level":1},{"t_ms":9000,"level":1,"ease":"step"},
                                      {"t_ms":9001,"level":0},{"t_ms":60000,"level":0}])");
  const Json pulse = rig.call(
      game, "effect.pulse",
      {{"direction", "front"}, {"current_a", 15}, {"duration_ms", 9000}, {"delay_ms", 9000}});
  rig.call(game, "effect.stop_all");
  rig.run(5);
  const Json pattern = rig.call(
      game, "effect.play",
      {{"keyframes", frames}, {"current_a", 15}, {"duration_ms", 9000}, {"delay_ms", 9000}});
  EXPECT_NEAR(pattern["headroom_s"].get<double>(), pulse["headroom_s"].get<double>(), 0.5);
}

TEST(Play, BothMomentsAreIntegratedNotSampled) {
  const auto frame = [](double t_ms, double level, model::Ease ease) {
    protocol::Keyframe k;
    k.t_ms = static_cast<std::int64_t>(t_ms);
    k.level = level;
    k.ease = ease;
    return k;
  };
  // On for 1 ms in ten, over a second: a comb that equidistant samples would miss.
  std::vector<protocol::Keyframe> comb;
  for (int i = 0; i < 100; ++i) {
    comb.push_back(frame(10 * i, 1, model::Ease::kStep));
    comb.push_back(frame(10 * i + 1, 0, model::Ease::kStep));
  }
  comb.push_back(frame(1000, 0, model::Ease::kStep));
  const KeyframeTrackPtr track = make_keyframe_track(comb, model::thesis_ball().array).value();
  EXPECT_NEAR(track->mean_over(1000).first.x, 0.1, 1e-9);
  EXPECT_NEAR(track->mean_over(1000).second.row[0].x, 0.1, 1e-9);
  EXPECT_NEAR(track->mean_over(1).second.row[0].x, 1.0, 1e-9);
  // A ramp: mean 1/2, mean square 1/3; its first half 1/4 and 1/12.
  const KeyframeTrackPtr ramp =
      make_keyframe_track({frame(0, 0, model::Ease::kLinear), frame(500, 1, model::Ease::kLinear)},
                          model::thesis_ball().array)
          .value();
  EXPECT_NEAR(ramp->mean_over(500).first.x, 0.5, 1e-9);
  EXPECT_NEAR(ramp->mean_over(500).second.row[0].x, 1.0 / 3, 1e-9);
  EXPECT_NEAR(ramp->mean_over(250).first.x, 0.25, 1e-9);
  EXPECT_NEAR(ramp->mean_over(250).second.row[0].x, 1.0 / 12, 1e-9);
  EXPECT_EQ(ramp->mean_over(0).first.x, 0.0);
}

TEST(Play, APatternThatIsTooLongNeedsAnEnd) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  Json slow{{"pattern", "breath"}, {"rate", 0.4}};
  const Json refused = rig.call(game, "effect.play", slow);
  EXPECT_EQ(refused["data"]["field"], "duration_ms");
  EXPECT_EQ(refused["data"]["value"], 12'500);
  slow["lease_ms"] = 5000;
  EXPECT_EQ(rig.call(game, "effect.play", slow)["accepted"], true);
}

TEST(Play, KeyFrameSlotsAreSharedReusedAndFreed) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const auto frames = [](int number) {
    Json list = Json::array();
    for (int i = 0; i < 256; ++i) list.push_back({{"t_ms", 30 * i + number}, {"level", 0.1}});
    return list;
  };
  FakeClient& other = rig.connect();
  for (int i = 0; i < 8; ++i) {
    const Json a = rig.call(i < 4 ? game : other, "effect.play",
                            {{"keyframes", frames(i)}, {"lease_ms", 9000}});
    ASSERT_TRUE(a.contains("accepted")) << i << a;
    rig.run(1);
    if (i != 3) continue;
    const Json share = rig.call(game, "effect.play", {{"pattern", "tick"}});
    EXPECT_EQ(share["data"]["limit"], 1024) << "half is for others";
  }
  EXPECT_EQ(rig.call(game, "effect.play", {{"keyframes", frames(3)}})["accepted"], true)
      << "these are there already";
  const Json full = rig.call(rig.connect(), "effect.play", {{"pattern", "tick"}});
  EXPECT_EQ(full["code"], -32001);
  EXPECT_EQ(full["data"]["limit"], 2048);
  rig.call(game, "effect.stop", {{"effect", 1}});
  rig.run(5);
  EXPECT_EQ(rig.call(game, "effect.play", {{"keyframes", frames(9)}})["accepted"], true);
  rig.call(game, "effect.stop_all");
  rig.run(5);
  for (int i = 20; i < 60; ++i) {
    EXPECT_EQ(rig.call(game, "effect.play", {{"keyframes", frames(i)}, {"slot", "x"}})["accepted"],
              true)
        << i;
    rig.run(2);
  }
}

TEST(Play, ABatchMayHave64CommandsAndMoreAreRefused) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  Json batch = Json::array();
  for (int effect = 0; effect < 3; ++effect) {
    Json frames = Json::array();
    for (int i = 0; i < 256; ++i) frames.push_back({{"t_ms", 30 * i + effect}, {"level", 0.1}});
    batch.push_back({{"jsonrpc", "2.0"},
                     {"id", effect},
                     {"method", "effect.play"},
                     {"params", {{"keyframes", frames}}}});
  }
  const Json responses = rig.exchange(game, batch.dump());
  EXPECT_TRUE(responses[0].contains("result")) << responses[0];
  EXPECT_TRUE(responses[1].contains("result")) << responses[1];
  const Json refused = responses[2]["error"];
  EXPECT_EQ(refused["code"], -32001);
  EXPECT_EQ(refused["data"]["limit"], 64);
  EXPECT_FALSE(refused["data"].contains("retry_after_ms")) << "in a batch it would never fit";
  EXPECT_TRUE(rig.exchange(game, batch[2].dump()).contains("result"))
      << "in a line of its own it does";
}

}  // namespace
}  // namespace hedgehog::server

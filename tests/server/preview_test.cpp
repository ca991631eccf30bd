// SPDX-License-Identifier: MIT
// effect.preview against the effect played afterwards.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "daemon/server/effects/preview.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

Json preview(ServerRig& rig, FakeClient& client, const std::string& method, const Json& params) {
  return rig.call(client, "effect.preview", {{"method", method}, {"params", params}});
}

/// The measured currents, a sample a millisecond.
std::vector<model::Vec3> flowing(ServerRig& rig, model::Tick ticks) {
  std::vector<model::Vec3> currents;
  for (model::Tick i = 0; i < ticks; ++i) {
    rig.run(1);
    currents.push_back(rig.world.board().plant().current_a());
  }
  return currents;
}

/// The largest difference between a timeline of means over `step` and the currents `lag` later.
double difference(const Json& timeline, std::size_t step, const std::vector<model::Vec3>& currents,
                  std::size_t lag) {
  double worst = 0.0;
  for (std::size_t i = 0; i < timeline.size() && (i + 1) * step + lag <= currents.size(); ++i) {
    model::Vec3 sum;
    for (std::size_t k = 0; k < step; ++k) sum = sum + currents[i * step + k + lag];
    for (int axis = 0; axis < 3; ++axis) {
      const double previewed = timeline[i][static_cast<std::size_t>(axis)].get<double>();
      worst = std::max(worst, std::abs(previewed - sum[axis] / static_cast<double>(step)));
    }
  }
  return worst;
}

/// From the response to the first current there is a delay of a few ticks, which a preview does not
/// have.
constexpr std::size_t kLongestLag = 6;

void expect_equals_played(const std::string& method, const Json& params, double within_a) {
  SCOPED_TRACE(method + params.dump());
  ServerRig rig;
  FakeClient& game = rig.connect();
  const Json previewed = preview(rig, game, method, params);
  ASSERT_TRUE(previewed.contains("current_a")) << previewed;
  rig.run(20);
  EXPECT_EQ(rig.plant_current_a(), 0.0) << "it touches nothing";
  EXPECT_TRUE(rig.call(game, "device.status")["effects"].empty());

  rig.call(game, method, params);
  const auto currents = flowing(
      rig, previewed["duration_ms"].get<model::Tick>() + static_cast<model::Tick>(kLongestLag));
  double best_a = std::numeric_limits<double>::infinity();
  for (std::size_t lag = 0; lag < kLongestLag; ++lag) {
    best_a = std::min(best_a, difference(previewed["current_a"],
                                         previewed["step_ms"].get<std::size_t>(), currents, lag));
  }
  EXPECT_LT(best_a, within_a);
  double peak_a = 0.0;
  for (const model::Vec3& a : currents) peak_a = std::max(peak_a, norm(a));
  EXPECT_GT(peak_a, 1.0);
  EXPECT_NEAR(previewed["peak_current_a"].get<double>(), peak_a, 0.02 * peak_a + 0.02);
  EXPECT_NEAR(previewed["peak_temperature_c"].get<double>(),
              rig.world.board().plant().hottest_winding_c(), 0.3);
}

TEST(Preview, EqualsWhatIsThenPlayed) {
  expect_equals_played("effect.pulse", {{"direction", "left"}, {"current_a", 12}}, 0.3);
  expect_equals_played("effect.pulse",
                       {{"direction", {1, 1, 1}}, {"attack_ms", 50}, {"fade_ms", 50}}, 0.15);
  expect_equals_played("effect.play", {{"pattern", "heartbeat"}, {"current_a", 10}}, 0.3);
  expect_equals_played("effect.play", {{"pattern", "rain"}, {"rotate_to", "left"}}, 0.4);
  expect_equals_played("effect.circle", {{"duration_ms", 3000}, {"stepping", "smooth"}}, 0.15);
  expect_equals_played("effect.vibrate", {{"frequency_hz", 20}, {"duration_ms", 200}}, 0.4);
}

TEST(Preview, DutyHoldsTheCurrentAndTheTimelineIsShort) {
  ServerRig rig;
  FakeClient& game = rig.connect(protocol::Role::kObserve);
  const Json previewed = preview(rig, game, "effect.hold",
                                 {{"direction", "up"}, {"current_a", 5}, {"lease_ms", 9999}});
  EXPECT_EQ(previewed["duration_ms"], 9999);
  EXPECT_EQ(previewed["step_ms"], 50);
  EXPECT_EQ(previewed["duty"].size(), 200u);
  EXPECT_NEAR(previewed["duty"][100][2].get<double>(), 5 * 0.45 / 12, 0.01);
  EXPECT_NEAR(previewed["duty"][100][0].get<double>(), 0, 1e-3);
  EXPECT_EQ(previewed["limited_by"], nullptr);
  EXPECT_EQ(previewed["limited_from_ms"], nullptr);
  EXPECT_EQ(previewed["delivered"]["min"], 1);
  EXPECT_GT(previewed["peak_temperature_c"], previewed["temperature_c"]);
}

TEST(Preview, ReportsReductionByHeatAndByTheOwnersGain) {
  device::SimulatedBoardOptions hot;
  hot.ambient_c = 30.0;
  hot.start_c = 30.0;
  ServerRig rig({}, hot);
  FakeClient& game = rig.connect();
  // A hot winding in a cool ball: otherwise the skin limit would apply.
  for (const int duration_ms : {10'000, 4000}) {
    rig.call(game, "effect.pulse",
             {{"direction", "left"}, {"level", 1}, {"duration_ms", duration_ms}});
    rig.run(duration_ms);
  }
  const Json params{{"direction", "left"}, {"level", 1}, {"duration_ms", 8000}};
  const Json previewed = preview(rig, game, "effect.pulse", params);
  EXPECT_EQ(previewed["limited_by"], "thermal");
  EXPECT_GT(previewed["limited_from_ms"], 300);
  EXPECT_LT(previewed["delivered"]["min"], 0.9);
  EXPECT_LT(previewed["peak_temperature_c"], 70);

  rig.call(game, "events.subscribe", {{"types", {"effect_ended"}}});
  rig.call(game, "effect.pulse", params);
  rig.run(8100);
  const auto events = rig.on_event(game);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(events[0]["delivered"]["mean"].get<double>(),
              previewed["delivered"]["mean"].get<double>(), 0.04);

  rig.run(30'000);
  rig.call(game, "output.set_gain", {{"gain", 0.5}});
  const Json halved = preview(rig, game, "effect.pulse", {{"direction", "left"}});
  EXPECT_EQ(halved["limited_by"], "configuration");
  EXPECT_NEAR(halved["peak_current_a"].get<double>(), 2.5, 0.1);
}

TEST(Preview, WorksOnABallThatIsNotArmed) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "device.emergency_stop");
  const Json previewed = preview(rig, game, "effect.pulse", {{"direction", "left"}});
  EXPECT_NEAR(previewed["peak_current_a"].get<double>(), 5.0, 0.2);
  rig.run(50);
  EXPECT_EQ(rig.plant_current_a(), 0.0);
}

TEST(Preview, RefusesAsPlayingDoesAndLimitsConcurrency) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  EXPECT_EQ(preview(rig, game, "effect.play", {{"pattern", "nothing"}})["code"], -32008);
  EXPECT_EQ(preview(rig, game, "effect.pulse", {{"direction", "left"}, {"level", 2}})["code"],
            -32602);
  EXPECT_EQ(rig.call(game, "effect.preview", {{"method", "effect.pulse"}})["data"]["field"],
            "params");
  EXPECT_EQ(rig.call(game, "effect.preview")["data"]["field"], "method");
  std::string batch;
  for (int i = 0; i < 6; ++i) {
    batch += (i == 0 ? "[" : ",") +
             Json{{"jsonrpc", "2.0"},
                  {"id", i},
                  {"method", "effect.preview"},
                  {"params", {{"method", "effect.circle"}, {"params", {{"duration_ms", 9000}}}}}}
                 .dump();
  }
  const Json responses = rig.exchange(game, batch + "]");
  ASSERT_EQ(responses.size(), 6u);
  EXPECT_TRUE(responses[0].contains("result"));
  EXPECT_EQ(std::count_if(responses.begin(), responses.end(),
                          [](const Json& a) { return a.contains("error"); }),
            5)
      << "one connection works out one";
}

TEST(Preview, OfADisconnectedClientIsCancelled) {
  ServerRig rig;
  const Json long_one{
      {"jsonrpc", "2.0"},
      {"id", 1},
      {"method", "effect.preview"},
      {"params", {{"method", "effect.circle"}, {"params", {{"duration_ms", 9000}}}}}};
  std::vector<FakeClient*> clients;
  for (std::size_t i = 0; i < Preview::kMaxAtOnce; ++i) {
    clients.push_back(&rig.connect(protocol::Role::kObserve));
    rig.server->line(clients.back()->session, long_one.dump());
  }
  FakeClient& late = rig.connect();
  const Json busy = preview(rig, late, "effect.pulse", {{"direction", "left"}});
  EXPECT_EQ(busy["code"], -32001);
  EXPECT_EQ(busy["data"]["limit"], Preview::kMaxAtOnce);
  for (FakeClient* client : clients) rig.server->drop_responses(client->session);
  rig.run(1);
  EXPECT_TRUE(preview(rig, late, "effect.pulse", {{"direction", "left"}}).contains("duty"));
  rig.run(100);
  for (FakeClient* client : clients) EXPECT_TRUE(client->lines.empty());
}

}  // namespace
}  // namespace hedgehog::server

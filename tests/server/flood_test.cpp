// SPDX-License-Identifier: MIT
// Ids and slots of effects, and clients that request more of them than there are.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/rig/sanitized.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

Json left_pulse() { return {{"direction", "left"}}; }

TEST(Registry, NoEffectHasTheNumberOfAFreePlace) {
  EffectRegistry registry(std::numeric_limits<control::EffectId>::max() - 1);
  EXPECT_EQ(registry.add(7).id, std::numeric_limits<control::EffectId>::max());
  const Effect& next = registry.add(7);
  EXPECT_EQ(next.id, 1u);
  EXPECT_EQ(next.place, 1);
  EXPECT_EQ(registry.playing(7).size(), 2u);
}

TEST(Flood, AFloodingClientIsBusyAndOthersAreNot) {
  ServerRig rig;
  FakeClient& flood = rig.connect();
  FakeClient& game = rig.connect();
  rig.call(flood, "effect.vibrate", {{"slot", "x"}, {"lease_ms", 9000}});
  int busy = 0;
  for (int i = 0; i < 1000; ++i) {
    rig.server->line(flood.session,
                     R"({"jsonrpc":"2.0","id":1,"method":"effect.update","params":{"slot":"x"}})");
  }
  for (const auto& line : flood.lines)
    busy += Json::parse(line.text).value("error", Json::object()).value("code", 0) == -32001;
  EXPECT_GT(busy, 500);
  EXPECT_TRUE(rig.call(game, "effect.pulse", left_pulse()).contains("effect"));
  rig.run(20);
  EXPECT_FALSE(rig.device_view->outbox().waiting());
  EXPECT_EQ(rig.device_view->now().applied_seq, rig.device_view->outbox().last_seq());
}

/// The active effects in the status.
Json playing(ServerRig& rig, FakeClient& client) {
  return rig.call(client, "device.status")["effects"];
}

TEST(Flood, StartsInASlotWithinOneTickCoalesce) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe");
  constexpr int kStarts = 1000;
  for (int tick = 0; tick < 3; ++tick) {
    for (int i = 1; i <= kStarts; ++i) {
      const Json params{{"slot", "x"}, {"direction", "left"}, {"current_a", 0.001 * i}};
      const bool pulse = i % 2 == 0;
      rig.server->line(game.session, Json{{"jsonrpc", "2.0"},
                                          {"id", i},
                                          {"method", pulse ? "effect.pulse" : "effect.hold"},
                                          {"params", params}}
                                         .dump());
    }
    rig.run(1);
  }
  Json last;
  int responses = 0;
  for (const auto& line : game.lines) {
    if (line.kind != LineKind::kResponse) continue;
    last = Json::parse(line.text);
    responses += last.contains("result");
  }
  EXPECT_EQ(responses, 3 * kStarts) << "none was busy";
  rig.run(5);
  FakeClient& watcher = rig.connect();
  const Json effects = playing(rig, watcher);
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_EQ(effects[0]["effect"], last["result"]["effect"]);
  EXPECT_EQ(effects[0]["method"], "effect.pulse");
  EXPECT_NEAR(effects[0]["current_a"].get<double>(), 0.001 * kStarts, 1e-6);
  EXPECT_GE(rig.device_view->now().applied_seq, last["result"]["seq"].get<std::uint64_t>());
  int started = 0;
  for (const Json& event : rig.on_event(game)) started += event["type"] == "effect_started";
  EXPECT_LE(started, 4) << "one a tick";
  game.lines.clear();
  rig.call(game, "effect.stop", {{"slot", "x"}});
  rig.run(2);
  EXPECT_TRUE(playing(rig, watcher).empty());
}

TEST(Flood, PatternsInASlotWithinOneTickCoalesceToo) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  for (int i = 1; i <= 500; ++i) {
    const Json frames = {{{"t_ms", 0}, {"level", 1}}, {{"t_ms", 900}, {"level", 1}}};
    const Json params{
        {"slot", "x"}, {"keyframes", frames}, {"current_a", 0.01 * i}, {"loop", true}};
    rig.server->line(
        game.session,
        Json{{"jsonrpc", "2.0"}, {"id", i}, {"method", "effect.play"}, {"params", params}}.dump());
    EXPECT_TRUE(Json::parse(game.lines.back().text).contains("result")) << game.lines.back().text;
  }
  rig.run(5);
  const Json effects = playing(rig, rig.connect());
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_NEAR(effects[0]["current_a"].get<double>(), 5.0, 1e-6);
}

TEST(Flood, AWaitingStartIsStoppedUpdatedAndDroppedAsIfItPlayed) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const auto hold = [&](double current_a) {
    return rig.exchange(
        game, Json{{"jsonrpc", "2.0"},
                   {"id", 1},
                   {"method", "effect.hold"},
                   {"params", {{"slot", "x"}, {"direction", "left"}, {"current_a", current_a}}}}
                  .dump());
  };
  const auto update = [&](double current_a) {
    return rig.exchange(game, Json{{"jsonrpc", "2.0"},
                                   {"id", 1},
                                   {"method", "effect.update"},
                                   {"params", {{"slot", "x"}, {"current_a", current_a}}}}
                                  .dump());
  };
  hold(1);
  hold(2);
  update(3);
  hold(4);
  rig.run(5);
  ASSERT_EQ(playing(rig, game).size(), 1u);
  EXPECT_NEAR(playing(rig, game)[0]["current_a"].get<double>(), 4, 1e-6) << "the last";
  hold(1);
  hold(2);
  rig.exchange(game, R"({"jsonrpc":"2.0","id":1,"method":"effect.stop","params":{"slot":"x"}})");
  rig.run(5);
  EXPECT_TRUE(playing(rig, game).empty());
  FakeClient& watcher = rig.connect();
  hold(1);
  hold(2);
  rig.disconnect(game);
  rig.run(5);
  EXPECT_TRUE(playing(rig, watcher).empty());
}

TEST(Flood, OfManyClientsBlocksNoOther) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  std::vector<FakeClient*> flood;
  for (int i = 0; i < 12; ++i) flood.push_back(&rig.connect());
  int served = 0;
  constexpr int kPulses = repetitions(10);
  for (int tick = 0; tick < 20 * kPulses; ++tick) {
    for (FakeClient* one : flood) {
      for (int i = 0; i < 40; ++i) {
        rig.server->line(one->session,
                         R"({"jsonrpc":"2.0","method":"effect.vibrate","params":{"slot":")" +
                             std::to_string(i % 4) + R"(","lease_ms":9000}})");
      }
    }
    if (tick % 20 == 19) {
      served += rig.call(game, "effect.pulse", {{"direction", "left"}, {"duration_ms", 5}})
                    .contains("effect");
    }
    rig.run(1);
  }
  EXPECT_EQ(served, kPulses);
}

TEST(Registry, ManyEndingOnesLeavePlacesForOthersAndTheLastForNewOwners) {
  EffectRegistry registry;
  std::vector<int> held;
  for (ConnectionId owner = 1; owner <= 8; ++owner) {
    held.push_back(0);
    while (registry.capacity(owner, false) == EffectRegistry::Capacity::kYes) {
      registry.add(owner).ending = true;
      ++held.back();
    }
  }
  EXPECT_EQ(held, (std::vector{32, 32, 28, 14, 7, 4, 2, 1}));
  EXPECT_EQ(registry.capacity(8, false), EffectRegistry::Capacity::kPlacesFull);
  EXPECT_EQ(registry.capacity(9, false), EffectRegistry::Capacity::kYes);
}

}  // namespace
}  // namespace hedgehog::server

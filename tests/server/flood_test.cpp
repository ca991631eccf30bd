// SPDX-License-Identifier: MIT
// Numbers and places of effects, and those who want more of them than there are.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/rig/sanitized.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

Json left_pulse() { return {{"direction", "left"}}; }

TEST(Registry, NoEffectHasTheNumberThatMarksAFreePlace) {
  EffectRegistry registry(std::numeric_limits<control::EffectId>::max() - 1);
  EXPECT_EQ(registry.add(7).id, std::numeric_limits<control::EffectId>::max());
  const Effect& next = registry.add(7);
  EXPECT_EQ(next.id, 1u);
  EXPECT_EQ(next.place, 1);
  EXPECT_EQ(registry.playing(7).size(), 2u);
}

TEST(Flood, WhoFloodsIsBusyAndOthersAreNot) {
  ServerRig rig;
  FakeClient& flood = rig.connect();
  FakeClient& game = rig.connect();
  int busy = 0;
  for (int i = 0; i < 1000; ++i) {
    rig.server->line(flood.session,
                     R"({"jsonrpc":"2.0","id":1,"method":"effect.vibrate","params":{"slot":"x"}})");
  }
  for (const auto& line : flood.lines)
    busy += Json::parse(line.text).value("error", Json::object()).value("code", 0) == -32001;
  EXPECT_GT(busy, 500);
  EXPECT_TRUE(rig.call(game, "effect.pulse", left_pulse()).contains("effect"));
  rig.run(20);
  EXPECT_FALSE(rig.device_view->outbox().waiting());
  EXPECT_EQ(rig.device_view->now().applied_seq, rig.device_view->outbox().last_seq());
}

TEST(Flood, OfManyKeepsNobodyOut) {
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

TEST(Registry, ManyEndingOnesLeaveAsManyPlacesToOthersAndTheLastToNewcomers) {
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

// SPDX-License-Identifier: MIT
// Latency that hedgehog-gamepad adds between a game and the ball. The figures are in the guest's
// time; none of them is asserted.
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/vm/gamepad_bench.h"

namespace hedgehog::vm {
namespace {

constexpr std::size_t kRepetitions = 1000;

class GamepadLatency : public GamepadBench {
 protected:
  void SetUp() override {
    begin();
    if (HasFatalFailure()) return;
    game_.emplace(node());
    ball_.reset();  // its telemetry would compete for the guest's only processor
  }
  /// Tilts to the right, without waiting for a response.
  void tilt(bool tilted) {
    const model::Quaternion q = tilted ? model::axis_angle(kFront, 60) : model::Quaternion{};
    const Json request{{"jsonrpc", "2.0"},
                       {"method", "sim.set"},
                       {"params", {{"orientation", {{"w", q.w}, {"x", q.x}, {"y", 0}, {"z", 0}}}}}};
    daemon_->client().send(request.dump() + "\n");
  }
  static void report(const std::string& what, std::vector<double> samples_ms) {
    ASSERT_EQ(samples_ms.size(), kRepetitions);
    std::sort(samples_ms.begin(), samples_ms.end());
    figure(what + ", p50", samples_ms[kRepetitions / 2 - 1], "ms");
    figure(what + ", p99", samples_ms[kRepetitions * 99 / 100 - 1], "ms");
  }

  std::optional<EventNode> game_;
};

// Both paths end with the same event of the daemon, written when the tick has run.
TEST_F(GamepadLatency, FromAGamesPlayToTheEffect) {
  RawClient& client = daemon_->client();
  client.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_started"}}});
  ff_effect effect{};
  effect.type = FF_CONSTANT;
  effect.id = -1;
  effect.replay.length = 1;
  effect.u.constant.level = 0x2000;
  ASSERT_EQ(game_->upload(effect), 0);
  std::vector<double> by_game;
  std::vector<double> by_client;
  for (std::size_t i = 0; i < kRepetitions; ++i) {
    const double played = now_ms();
    game_->play(effect.id);
    client.notification("event", "effect_started");
    by_game.push_back(now_ms() - played);

    const double start_ms = now_ms();
    client.send(R"({"jsonrpc":"2.0","method":"effect.pulse","params":{"direction":"front",)"
                R"("level":0.3,"duration_ms":1}})"
                "\n");
    client.notification("event", "effect_started");
    by_client.push_back(now_ms() - start_ms);
  }
  report("play at the event node to effect_started", by_game);
  report("effect.pulse of a client to effect_started", by_client);
}

// For comparison, the same orientation in the telemetry of a client with the bridge's subscription.
TEST_F(GamepadLatency, FromTiltToTheAxis) {
  RawClient& client = daemon_->client();
  const auto latencies = [&](const std::function<bool()>& is_tilted) {
    std::vector<double> samples;
    for (std::size_t i = 0; i < kRepetitions; ++i) {
      const bool tilted = i % 2 == 0;
      // The daemon publishes every 10 ms: this samples all phases of that period, not only the one
      // after a message.
      pause_ms(i * 7 % 10);
      const double turned = now_ms();
      tilt(tilted);
      while (is_tilted() != tilted) {
      }
      samples.push_back(now_ms() - turned);
    }
    return samples;
  };
  report("tilt to EV_ABS", latencies([&] {
           const auto event = game_->next();
           if (!event) throw std::runtime_error("the stick does not move");
           return game_->axis(ABS_X).value > 30'000;
         }));
  client.call("telemetry.subscribe", {{"rate_hz", 100}, {"fields", {"orientation"}}});
  report("tilt to the telemetry of a client", latencies([&] {
           return std::abs(client.notification("telemetry")["orientation"]["up"][1].get<double>()) >
                  0.5;
         }));
}

}  // namespace
}  // namespace hedgehog::vm

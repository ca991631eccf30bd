// SPDX-License-Identifier: MIT
// A daemon that ends no circle or sends nothing more does not hang a run.
#include "clients/study/session/player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/clients/fake_daemon.h"
#include "tests/study/fake_responses.h"

namespace hedgehog::study {
namespace {

using namespace std::chrono_literals;
using client::FakeDaemon;
using client::FakePeer;
using nlohmann::json;
using testing::HasSubstr;

/// Answers every request as a daemon does, but ends no circle. Each ping is followed by ten
/// telemetry messages, `tick_ms` apart in device time; 0: by none.
FakeDaemon::Script endless_circle(std::int64_t tick_ms) {
  return [tick_ms](FakePeer& peer) {
    const json responses = fake_responses();
    std::int64_t time_ns = 1'000'000'000;
    for (std::string line = peer.read(); !line.empty(); line = peer.read()) {
      const json request = json::parse(line);
      const std::string method = request["method"];
      if (request.contains("id")) {
        const json result = method == "ping" ? json{{"time_ns", time_ns}} : responses.at(method);
        peer.send_line(json{{"jsonrpc", "2.0"}, {"id", request["id"]}, {"result", result}}.dump());
      }
      for (int i = 0; method == "ping" && tick_ms > 0 && i < 10; ++i) {
        time_ns += tick_ms * 1'000'000;
        peer.send_line(
            json{{"jsonrpc", "2.0"}, {"method", "telemetry"}, {"params", {{"time_ns", time_ns}}}}
                .dump());
      }
    }
  };
}

client::Outcome<IntervalPlayed> play_with(
    const FakeDaemon& daemon, const std::function<bool()>& abort = [] { return false; },
    client::Milliseconds silence = 20s) {
  auto player = Player::open({daemon.address()}, 5s, silence);
  if (!player) return player.error();
  return player->play(1, {5.0, 10.0}, Pattern{}, std::nullopt, abort);
}

TEST(Player, ACircleThatNeverEndsIsAnErrorWhenItIsOverdue) {
  const FakeDaemon daemon(endless_circle(2'000));
  const auto played = play_with(daemon);
  ASSERT_FALSE(played.has_value());
  EXPECT_THAT(played.error().message, HasSubstr("no effect_ended event was received"));
  EXPECT_NE(played.error().failure, client::Failure::kRefused);
}

TEST(Player, ADaemonThatFallsSilentIsAnError) {
  const FakeDaemon daemon(endless_circle(0));
  const auto played = play_with(
      daemon, [] { return false; }, 100ms);
  ASSERT_FALSE(played.has_value());
  EXPECT_THAT(played.error().message, HasSubstr("no telemetry"));
  EXPECT_NE(played.error().failure, client::Failure::kRefused);
}

}  // namespace
}  // namespace hedgehog::study

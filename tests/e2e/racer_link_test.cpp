// SPDX-License-Identifier: MIT
// The racing game reports nothing as felt that the daemon does not carry out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <string>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/racing.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using racer::Feel;
using testing::HasSubstr;

TEST(Racer, AFrozenDaemonDelaysNoFrameAndIsReportedAsSilent) {
  const Home home;
  DaemonProcess daemon(home);
  Feel feel(addresses_of(daemon));
  ASSERT_TRUE(connects(feel));
  ASSERT_TRUE(eventually([&] {
    feel.frame({}, 0.0);
    return feel.ball().orientation.has_value();
  }));
  daemon.signal(SIGSTOP);
  EXPECT_TRUE(eventually([&] {
    feel.frame({racer::Hit{{1, 0, 0}, 500.0}}, 20.0);
    return !feel.ball().connected;
  }));
  const auto before = std::chrono::steady_clock::now();
  for (int frame = 0; frame < kRaceFrames; ++frame) feel.frame({racer::Skid{0.5}}, frame / 60.0);
  EXPECT_LT(std::chrono::steady_clock::now() - before, kBlockingDuration / 50);
  EXPECT_EQ(sentence(feel.ball()), "no telemetry from the daemon");
  EXPECT_TRUE(feel.ball().late);
  EXPECT_FALSE(feel.ball().orientation.has_value());
  feel.frame({racer::Hit{{1, 0, 0}, 500.0}, racer::Skid{0.5}}, 30.0);
  for (const racer::Played& played : feel.played()) EXPECT_FALSE(played.on_the_ball) << played.kind;
  EXPECT_EQ(feel.summary().pulses, 0);
  daemon.signal(SIGCONT);
  EXPECT_TRUE(eventually([&] {
    feel.frame({}, 100.0);
    return feel.ball().connected && feel.ball().orientation.has_value();
  }));
  EXPECT_FALSE(feel.ball().late);
}

TEST(Racer, ABallClaimedByAnotherClientIsNotReportedAsFelt) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient other(daemon.port());
  const auto claim = [&] { other.call("device.claim"); };
  claim();
  Feel feel(addresses_of(daemon));
  ASSERT_TRUE(connects(feel));
  claim();
  feel.frame({racer::Hit{{1, 0, 0}, 500.0}}, 1.0);
  EXPECT_TRUE(eventually([&] {
    claim();
    feel.frame({racer::Skid{0.5}}, 1.1);
    return sentence(feel.ball()) == "another client has exclusive use of the ball" &&
           feel.all_answered();
  }));
  EXPECT_EQ(sentence(feel.ball()), "another client has exclusive use of the ball");
  EXPECT_FALSE(feel.played().back().on_the_ball);
  EXPECT_EQ(feel.summary().pulses, 0);
  EXPECT_EQ(feel.summary().refused, 1);
  Program driver(home, hedgehog_racer(), {"lap", "--speed", "20", "--address", daemon.socket()});
  const Ended lap = wait_renewing(driver, claim);
  EXPECT_EQ(lap.exit_code, 69);
  EXPECT_THAT(lap.err, HasSubstr("another client has exclusive use of the ball"));
  other.call("device.release");
  EXPECT_TRUE(eventually([&] {
    feel.frame({racer::Skid{0.5}}, 3.0);
    return feel.ball().problem.empty() && feel.played().back().on_the_ball;
  }));
  ASSERT_TRUE(connects(feel, 4.0));
  feel.frame({racer::Hit{{1, 0, 0}, 500.0}}, 4.0);
  EXPECT_TRUE(eventually([&] {
    feel.frame({}, 4.1);
    return feel.all_answered();
  }));
  EXPECT_EQ(feel.summary().pulses, 1);
}

TEST(Racer, AnImpactThatWasNotSentIsCountedAsNotFelt) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient other(daemon.port());
  Feel feel(addresses_of(daemon));
  ASSERT_TRUE(connects(feel));
  other.call("device.emergency_stop");
  ASSERT_TRUE(eventually([&] {
    feel.frame({}, 0.0);
    return feel.ball().state == "disarmed";
  }));
  feel.frame({racer::Hit{{1, 0, 0}, 500.0}}, 10.0);
  EXPECT_EQ(feel.summary().refused, 1);
  daemon.stop(SIGKILL);
  ASSERT_TRUE(eventually([&] {
    feel.frame({}, 11.0);
    return !feel.ball().connected;
  }));
  EXPECT_FALSE(feel.ball().late);
  feel.frame({racer::Landing{500.0}}, 20.0);
  EXPECT_EQ(feel.summary().refused, 2);
  EXPECT_EQ(feel.summary().pulses, 0);
}

/// Runs a lap of 100 s at ten times real time, and takes the ball from it at its first hit. The lap
/// is stopped meanwhile, so that it does not end before.
Ended lap_with_lost_ball(const Home& home, const std::string& address,
                         const std::function<void()>& take_ball) {
  Program lap(home, hedgehog_racer(),
              {"lap", "--speed", "10", "--seconds", "100", "--json", "--address", address});
  EXPECT_TRUE(lap.prints(R"("type":"hit")"));
  lap.signal(SIGSTOP);
  take_ball();
  lap.signal(SIGCONT);
  return lap.wait();
}

/// The lap's summary counts every hit, some of them as not felt.
void expect_every_impact_counted(const Ended& ended) {
  const Json summary = Json::parse(ended.out.substr(ended.out.rfind("{\"type\":\"summary\"")));
  const Json& ball = summary["ball"];
  EXPECT_GT(ball["refused"], 0) << summary;
  EXPECT_EQ(ball["pulses"].get<int>() + ball["refused"].get<int>() + ball["left_out"].get<int>(),
            summary["hits"].get<int>() + summary["landings"].get<int>())
      << summary;
}

TEST(Racer, ALapThatEndsWithoutItsBallIsReported) {
  const Home home;
  DaemonProcess daemon(home);
  const Ended stopped = lap_with_lost_ball(
      home, daemon.socket(), [&] { RawClient(daemon.port()).call("device.emergency_stop"); });
  EXPECT_EQ(stopped.exit_code, 69);
  EXPECT_THAT(stopped.err, HasSubstr("the ball is disarmed"));
  expect_every_impact_counted(stopped);

  RawClient(daemon.port()).call("device.arm");
  const Ended killed = lap_with_lost_ball(home, daemon.socket(), [&] { daemon.stop(SIGKILL); });
  EXPECT_EQ(killed.exit_code, 69);
  EXPECT_THAT(killed.err, HasSubstr("no daemon answers"));
  expect_every_impact_counted(killed);
}

}  // namespace
}  // namespace hedgehog::e2e

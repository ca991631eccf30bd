// SPDX-License-Identifier: MIT
// The racing game on a real daemon: a hit on the car pushes the ball's pins on that side, and a hot
// ball is derated, not tripped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/json_vector.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/racing.h"
#include "tests/e2e/raw_client.h"
#include "tests/folders.h"
#include "tests/racer/tracks.h"

namespace hedgehog::e2e {
namespace {

using racer::Feel;
using racer::Race;
using racer::Vec3;
using testing::HasSubstr;

/// The next push in telemetry, as the sum of its samples up to the pause after it.
struct Push {
  Vec3 current_a{};
  double max_a = 0.0;
};

Push next_push(RawClient& observer) {
  Push push;
  EXPECT_TRUE(eventually([&] {
    const Vec3 current = vector_of(observer.notification("telemetry")["current_a"]);
    push.current_a = push.current_a + current;
    push.max_a = std::max(push.max_a, norm(current));
    return push.max_a > 1.0 && norm(current) < 0.05;
  }));
  return push;
}

RawClient& watching(RawClient& observer) {
  observer.call("telemetry.subscribe", {{"rate_hz", 200}, {"fields", {"current_a"}}});
  return observer;
}

/// Drives until an event of type `What` has happened and was played.
template <class What>
What drive_until(Race& race, Feel& feel, const racer::Controls& controls) {
  for (int step = 0; step < 1200; ++step) {
    race.step(controls);
    if (!race.race_events().empty()) EXPECT_TRUE(connects(feel, race.scene().time_s));
    feel.frame(race.race_events(), race.scene().time_s);
    for (const racer::RaceEvent& race_event : race.race_events())
      if (const auto* what = std::get_if<What>(&race_event)) return *what;
  }
  ADD_FAILURE() << "it never happened";
  return {};
}

TEST(Racer, AHitFromEachOfEightSidesPushesThere) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient observer(daemon.port());
  watching(observer);
  for (int eighth = 0; eighth < 8; ++eighth) {
    SCOPED_TRACE(45 * eighth);
    Feel feel(addresses_of(daemon));
    ASSERT_TRUE(connects(feel));
    Race race(racer::ball_thrown_from(45.0 * eighth, 100.0, 12.0));
    const auto hit = drive_until<racer::Hit>(race, feel, {});
    const Push push = next_push(observer);
    EXPECT_LT(model::angle_deg(push.current_a, racer::towards(45.0 * eighth)), 22.5);
    EXPECT_LT(model::angle_deg(push.current_a, hit.direction), 5.0);
    EXPECT_NEAR(push.max_a, racer::strength_of(racer::step_of(hit.impulse_n_s), 2.1, 15.0), 0.5);
    EXPECT_TRUE(eventually([&] {
      feel.frame({}, race.scene().time_s);
      return feel.all_answered();
    }));
    EXPECT_EQ(feel.summary().pulses, 1);
  }
}

TEST(Racer, ALandingPushesAndASkidVibratesFromBelow) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient observer(daemon.port());
  watching(observer);
  Feel feel(addresses_of(daemon));
  ASSERT_TRUE(connects(feel));
  racer::Track track = racer::open_ground();
  track.ramps.push_back({racer::flat_pose(25, 0, 0, 0), 6, 5, 1.0});
  Race jump(track);
  drive_until<racer::Landing>(jump, feel, {.throttle = 1.0});
  EXPECT_LT(model::angle_deg(next_push(observer).current_a, {0, 0, -1}), 5.0);

  track = racer::open_ground();
  track.patches.push_back({racer::flat_pose(0, 0, 0, 0), 200, 200, 0.1});
  Race ice(track);
  drive_until<racer::Skid>(ice, feel, {.steer = 0.5, .throttle = 1.0});
  EXPECT_LT(model::angle_deg(next_push(observer).current_a, {0, 0, -1}), 5.0);
}

TEST(Racer, TheGroundDirectionCirclesTheBallInATumbleAndAPauseEndsIt) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient observer(daemon.port());
  watching(observer);
  Feel feel(addresses_of(daemon));
  ASSERT_TRUE(connects(feel));
  for (const Vec3& down : {Vec3{0, 1, 0}, {0, 0.6, 0.8}, {0, 0, 1}, {0, -1, 0}}) {
    EXPECT_TRUE(eventually([&] {
      feel.frame({racer::Tumble{down}}, 1.0);
      const Vec3 current = vector_of(observer.notification("telemetry")["current_a"]);
      return norm(current) > 3.0 && model::angle_deg(current, down) < 3.0;
    }));
  }
  feel.pause();
  EXPECT_TRUE(eventually(
      [&] { return norm(vector_of(observer.notification("telemetry")["current_a"])) < 0.05; }));
}

TEST(Racer, ContinuesWithoutADaemonAndPlaysAgainWhenItReturns) {
  const Home home;
  auto daemon = std::make_unique<DaemonProcess>(home);
  const auto addresses = addresses_of(*daemon);
  Feel feel(addresses);
  ASSERT_TRUE(connects(feel));
  EXPECT_EQ(daemon->stop(), 0);
  EXPECT_TRUE(eventually([&] {
    feel.frame({racer::Hit{{1, 0, 0}, 500.0}}, 1.0);
    return !feel.ball().connected && !feel.ball().problem.empty();
  }));
  const auto before = std::chrono::steady_clock::now();
  for (int frame = 0; frame < kRaceFrames; ++frame)
    feel.frame({racer::Skid{0.5}}, 2.0 + frame / 60.0);
  EXPECT_LT(std::chrono::steady_clock::now() - before, kBlockingDuration / 50);
  daemon = std::make_unique<DaemonProcess>(home);
  ASSERT_TRUE(connects(feel));
  RawClient observer(daemon->port());
  watching(observer);
  ASSERT_TRUE(connects(feel, 30.0));
  feel.frame({racer::Hit{{0, -1, 0}, 2000.0}}, 30.0);
  EXPECT_LT(model::angle_deg(next_push(observer).current_a, {0, -1, 0}), 5.0);
}

TEST(Racer, ABallOfALowCurrentLimitIsPlayedSoftly) {
  const Home home;
  home.configure(R"({"limits": {"current_a": 1.5}})");
  DaemonProcess daemon(home);
  RawClient observer(daemon.port());
  watching(observer);
  Feel feel(addresses_of(daemon));
  ASSERT_TRUE(connects(feel));
  feel.frame({racer::Hit{{0, 1, 0}, 8000.0}}, 1.0);
  const Push push = next_push(observer);
  EXPECT_LT(model::angle_deg(push.current_a, {0, 1, 0}), 5.0);
  EXPECT_LT(push.max_a, 1.7);
}

Ended run_racer(const Home& home, const std::vector<std::string>& words,
                const std::string& address = "") {
  return Program(home, hedgehog_racer(), words, {"HEDGEHOG_ADDRESS=" + address}).wait();
}

Json last_line(const std::string& out) {
  std::istringstream text(out);
  std::string last;
  for (std::string line; std::getline(text, line);) last = line;
  return Json::parse(last);
}

/// Runs two minutes from a ball temperature of `start_c`; returns the summary's part about the
/// ball.
Json two_minutes_from(double start_c) {
  const Home home;
  home.configure(R"({"simulator": {"start_temperature_c": )" + std::to_string(start_c) + "}}");
  // Game and ball have separate clocks; at this speed they stay together on a busy machine.
  const std::string speed = std::to_string(attainable_speed(20));
  DaemonProcess daemon(home, {"--speed", speed});
  const Ended lap =
      run_racer(home, {"lap", "--speed", speed, "--seconds", "120", "--json"}, daemon.socket());
  EXPECT_EQ(lap.exit_code, 0) << lap.err;
  const Json summary = last_line(lap.out);
  EXPECT_EQ(summary["laps"], 4) << summary;
  EXPECT_EQ(summary["ball"]["tripped"], false);
  EXPECT_GT(summary["ball"]["pulses"], 20);
  EXPECT_TRUE(RawClient(daemon.port()).call("device.status")["last_trip"].is_null());
  return summary["ball"];
}

TEST(Racer, TwoMinutesOnAColdBallAreDeliveredInFull) {
  const Json ball = two_minutes_from(25.0);
  EXPECT_EQ(ball["turned_down_s"], 0.0) << ball;
  EXPECT_EQ(ball["derated_s"], 0.0) << ball;
  EXPECT_EQ(ball["least_limit_a"], 15.0) << ball;
}

TEST(Racer, TwoMinutesOnAHotBallNeverTripItAndTheSummaryReportsReductions) {
  const Json ball = two_minutes_from(66.8);
  EXPECT_GT(ball["turned_down_s"], 5.0) << ball;
  EXPECT_GT(ball["derated_s"], 0.0) << ball;
  EXPECT_LT(ball["least_gain"], 0.65) << ball;
  EXPECT_GE(ball["least_gain"], 0.39) << ball;
  EXPECT_LT(ball["least_limit_a"], 15.0) << ball;
}

TEST(Racer, TheLinesOfItsReadmeRun) {
  const Home home;
  const std::string speed = std::to_string(attainable_speed(60));
  DaemonProcess daemon(home, {"--speed", speed});
  std::ifstream text(source_folder() + "/clients/racer/README.md");
  int ran = 0;
  for (std::string line; std::getline(text, line);) {
    if (line.rfind("    hedgehog-racer lap", 0) != 0) continue;
    std::istringstream typed(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; typed >> word;) words.push_back(word);
    words.erase(words.begin());
    words.insert(words.end(), {"--speed", speed});
    const Ended ended = run_racer(home, words, daemon.socket());
    EXPECT_EQ(ended.exit_code, 0) << line << "\n" << ended.err;
    EXPECT_FALSE(ended.out.empty());
    ++ran;
  }
  EXPECT_EQ(ran, 3);
}

TEST(Racer, PrintsTheSameOnEveryRun) {
  const Home home;
  const Ended first = run_racer(home, {"lap", "--no-ball", "--json", "--seconds", "60"});
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_EQ(last_line(first.out)["ball"], nullptr);
  EXPECT_EQ(run_racer(home, {"lap", "--no-ball", "--json", "--seconds", "60"}).out, first.out);
}

TEST(Racer, UsageErrorsExitWith64AndAMissingDaemonWith69) {
  const Home home;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"fly"}, {"lap", "--seconds", "-1"}, {"lap", "--address", "a:b"}})
    EXPECT_EQ(run_racer(home, words).exit_code, 64);
  const Ended alone = run_racer(home, {"lap"}, home.path("nobody.sock"));
  EXPECT_EQ(alone.exit_code, 69);
  EXPECT_THAT(alone.err, HasSubstr("no daemon answers at " + home.path("nobody.sock")));
}

}  // namespace
}  // namespace hedgehog::e2e

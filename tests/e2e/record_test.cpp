// SPDX-License-Identifier: MIT
// hedgehogctl record: tilts, their tolerance, a ball at rest, too long a recording, no daemon,
// existing files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "model/quaternion.h"
#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/exit_codes.h"
#include "tests/e2e/json_vector.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {
namespace {

using model::axis_angle;
using model::Quaternion;
using testing::HasSubstr;

/// At rest for half a second, then once up and down each second.
double wave(double t_s) { return t_s < 0.5 ? 0.0 : std::sin(2.0 * 3.14159265358979 * (t_s - 0.5)); }

class Record : public testing::Test {
 protected:
  std::vector<std::string> record(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"--json", "record", file_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Ended ctl(const DaemonProcess& daemon, const std::vector<std::string>& arguments) const {
    return Program(home_, hedgehogctl(), arguments, {"HEDGEHOG_ADDRESS=" + daemon.socket()}).wait();
  }
  /// Five seconds, in which the ball is turned by what it is given for the seconds since the start.
  Ended record_turning(const DaemonProcess& daemon, std::vector<std::string> more,
                       const std::function<Quaternion(double)>& turned) const {
    RawClient other(daemon.port());
    const auto turn = [&other](const Quaternion& q) {
      other.call("sim.set", {{"orientation", json_of(q)}});
    };
    const auto now_s = [&other] { return other.call("ping")["time_ns"].get<double>() * 1e-9; };
    turn(turned(0.0));
    const double before_s = now_s();
    while (now_s() < before_s + 0.2) continue;
    more.insert(more.end(), {"--seconds", "5"});
    Program program(home_, hedgehogctl(), record(more), {"HEDGEHOG_ADDRESS=" + daemon.socket()});
    EXPECT_TRUE(
        eventually([&] { return other.call("connection.list")["connections"].size() == 2; }));
    const double start_s = now_s();
    while (!has_ended(program)) turn(turned(now_s() - start_s));
    return program.wait();
  }
  Json pattern() const { return Json::parse(home_.read("path.json")); }
  bool is_written() const { return std::filesystem::exists(file_); }

  Home home_;
  std::string file_ = home_.path("path.json");
};

TEST_F(Record, ABallAtRestIsAPatternOfItsFrontThatPlays) {
  const DaemonProcess daemon(home_);
  const Ended ended = ctl(daemon, record({"--seconds", "0.3", "--level", "0.5"}));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(Json::parse(ended.out)["keyframes"], 2);
  const Json frames = pattern()["keyframes"];
  ASSERT_EQ(frames.size(), 2u);
  for (const Json& frame : frames) {
    EXPECT_EQ(frame["direction"], Json::parse("[1,0,0]"));
    EXPECT_EQ(frame["level"], 0.5);
  }
  EXPECT_EQ(ctl(daemon, {"play", file_}).exit_code, 0);
}

TEST_F(Record, ATiltIsRelativeToTheOrientationAtTheBeginningAndThePointerSaysWhatPoints) {
  const DaemonProcess daemon(home_);
  // It lies turned to the left, and is tilted by 60 degrees round the room's front: its own back
  // goes down, by its own axes.
  const Quaternion turned_left = axis_angle({0, 0, 1}, 90);
  const Ended ended = record_turning(daemon, {"--pointer", "up"}, [&](double t_s) {
    return axis_angle({1, 0, 0}, 60.0 * std::clamp(t_s - 2.0, 0.0, 1.0)) * turned_left;
  });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Json frames = pattern()["keyframes"];
  EXPECT_GT(dot(vector_of(frames.front()["direction"]), {0, 0, 1}), 0.999) << frames.front();
  EXPECT_GT(dot(vector_of(frames.back()["direction"]), {-0.866, 0, 0.5}), 0.999) << frames.back();
}

TEST_F(Record, WhatIsWithinTheToleranceIsLeftOut) {
  const DaemonProcess daemon(home_);
  const auto nod = [](double t_s) { return axis_angle({0, 1, 0}, 12.0 * wave(t_s)); };
  const Ended rough = record_turning(daemon, {"--tolerance-deg", "30"}, nod);
  ASSERT_EQ(rough.exit_code, 0) << rough.err;
  EXPECT_EQ(Json::parse(rough.out)["keyframes"], 2);
  EXPECT_GT(Json::parse(rough.out)["error_deg"], 8);
  const Ended fine = record_turning(daemon, {"--tolerance-deg", "1", "--force"}, nod);
  ASSERT_EQ(fine.exit_code, 0) << fine.err;
  EXPECT_GT(Json::parse(fine.out)["keyframes"], 4);
  EXPECT_LE(Json::parse(fine.out)["error_deg"], 1);
}

TEST_F(Record, EndsByItselfAfterAMinuteOfTheBallsTime) {
  {
    const DaemonProcess daemon(home_, {"--speed", "20"});
    const Ended ended = ctl(daemon, record({}));
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
  }
  EXPECT_EQ(pattern()["keyframes"].back()["t_ms"], 60'000);
  // The lease is 1 s of the ball's time: at a higher speed a busy machine does not renew it in
  // time.
  const DaemonProcess daemon(home_, {"--speed", "3"});
  const Ended played = ctl(daemon, {"play", file_, "--current-a", "3"});
  EXPECT_EQ(played.exit_code, 0) << "whole, though one effect lasts 10 s at most: " << played.out;
}

TEST_F(Record, MoreThanAMinuteIsRefusedWithWhatIsAllowed) {
  const DaemonProcess daemon(home_);
  const Ended ended = ctl(daemon, record({"--seconds", "61"}));
  EXPECT_EQ(ended.exit_code, kUsage);
  EXPECT_THAT(ended.err, HasSubstr("--seconds"));
  EXPECT_THAT(ended.err, HasSubstr("60"));
  EXPECT_FALSE(is_written());
}

TEST_F(Record, CtrlCEndsTheRecordingAndSavesIt) {
  const DaemonProcess daemon(home_);
  RawClient other(daemon.port());
  Program program(home_, hedgehogctl(), record({}), {"HEDGEHOG_ADDRESS=" + daemon.socket()});
  ASSERT_TRUE(eventually([&] { return other.call("connection.list")["connections"].size() == 2; }));
  const double from_ns = other.call("ping")["time_ns"];
  while (other.call("ping")["time_ns"].get<double>() < from_ns + 1e9) continue;
  program.signal(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_GT(pattern()["keyframes"].back()["t_ms"], 0);
}

TEST_F(Record, ARecordingIsSavedWhenTheDaemonEnds) {
  DaemonProcess daemon(home_);
  RawClient other(daemon.port());
  Program program(home_, hedgehogctl(), record({}), {"HEDGEHOG_ADDRESS=" + daemon.socket()});
  ASSERT_TRUE(eventually([&] { return other.call("connection.list")["connections"].size() == 2; }));
  const double from_ns = other.call("ping")["time_ns"];
  while (other.call("ping")["time_ns"].get<double>() < from_ns + 1e9) continue;
  daemon.stop(SIGKILL);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, kUnavailable);
  EXPECT_EQ(Json::parse(ended.err)["error"]["data"]["name"], "closed");
  EXPECT_EQ(Json::parse(ended.out)["file"], file_);
  EXPECT_GE(pattern()["keyframes"].size(), 2u);
}

TEST_F(Record, ABallWithoutASensorRecordsNothing) {
  home_.configure(R"({"imu":{"type":"none"}})");
  const DaemonProcess daemon(home_);
  const Ended ended = ctl(daemon, record({"--seconds", "0.3"}));
  EXPECT_EQ(ended.exit_code, kUnavailable);
  EXPECT_THAT(ended.err, HasSubstr("nothing was recorded: the ball has no orientation sensor"));
  EXPECT_FALSE(is_written());
}

TEST_F(Record, AnExistingFileIsReplacedOnlyByForce) {
  const DaemonProcess daemon(home_);
  home_.write("path.json", "mine");
  const Ended refused = ctl(daemon, record({"--seconds", "0.1"}));
  EXPECT_EQ(refused.exit_code, kCannotCreate);
  EXPECT_THAT(refused.err, HasSubstr("path.json is there already; --force replaces it"));
  EXPECT_EQ(home_.read("path.json"), "mine");
  EXPECT_EQ(ctl(daemon, record({"--seconds", "0.3", "--force"})).exit_code, 0);
  EXPECT_EQ(pattern()["name"], "recorded/path");
}

TEST_F(Record, AnUnwritableFileIsRefusedBeforeTheRecording) {
  const DaemonProcess daemon(home_);
  // Without --seconds: a recording that started would last a minute.
  const Ended missing_folder = ctl(daemon, {"record", home_.path("nowhere/path.json")});
  EXPECT_EQ(missing_folder.exit_code, kCannotCreate);
  EXPECT_THAT(missing_folder.err, HasSubstr("there is no folder " + home_.path("nowhere")));
  const Ended unnamed = ctl(daemon, record({"--name", "No Name"}));
  EXPECT_EQ(unnamed.exit_code, kUsage);
  EXPECT_THAT(unnamed.err, HasSubstr("is not a valid pattern name"));
  EXPECT_EQ(ctl(daemon, record({"--pointer", "nowhere"})).exit_code, kUsage);
  EXPECT_FALSE(is_written());
}

}  // namespace
}  // namespace hedgehog::e2e

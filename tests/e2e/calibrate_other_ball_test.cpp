// SPDX-License-Identifier: MIT
// hedgehogctl calibrate on balls that differ from the daemon's device file, as in a bring-up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "model/vec3.h"
#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

struct Ball {
  friend void PrintTo(const Ball& ball, std::ostream* out) { *out << ball.name; }
  const char* name;
  std::array<double, 3> r25_ohm;
  double inductance_h;
  const char* matrix;
  /// Directions that a hand feels for windings x, y and z.
  const char* pushed;
};

std::string file_of(const Ball& ball) {
  const Json json{{"name", "truth"},
                  {"r25_ohm", ball.r25_ohm},
                  {"inductance_h", ball.inductance_h},
                  {"coil_matrix", Json::parse(ball.matrix)}};
  return json.dump();
}

/// Where the pins of the simulated ball extend most while `direction` is driven in `frame`.
std::string felt(RawClient& hand, const Json& direction, const std::string& frame,
                 double current_a) {
  const Json push{{"direction", direction}, {"frame", frame}, {"current_a", current_a}};
  const auto time_ns = [](const Json& telemetry) {
    return telemetry["time_ns"].get<std::int64_t>();
  };
  constexpr std::int64_t kSettledNs = 200'000'000;
  std::int64_t settled_ns = 0;
  Json effect;
  Json telemetry;
  hand.call("telemetry.subscribe", {{"rate_hz", 50}, {"fields", {"pins", "state", "reason"}}});
  do {
    telemetry = hand.notification("telemetry");
    const Json held = renew_hold(hand, push);
    if (!held.contains("effect")) return held.dump();
    // In the ball's time: telemetry sent before this hold may still be unread. The hold is a new
    // one if the lease expired on a busy machine.
    if (held["effect"] != effect) settled_ns = time_ns(hand.call("device.status")) + kSettledNs;
    effect = held["effect"];
  } while (time_ns(telemetry) <= settled_ns && telemetry["state"] == "armed");
  if (telemetry["state"] != "armed") return telemetry.dump();
  const Json& forces = telemetry["pins"]["force_n"];
  const auto pin = std::max_element(forces.begin(), forces.end()) - forces.begin();
  const Json at = hand.call("device.describe")["pins"][static_cast<std::size_t>(pin)]["position"];
  hand.call("effect.stop_all");
  hand.call("telemetry.unsubscribe");
  const std::array<double, 3> position = at;
  const auto largest = std::max_element(position.begin(), position.end(), [](double a, double b) {
    return std::abs(a) < std::abs(b);
  });
  constexpr std::array<std::array<const char*, 2>, 3> kSides{
      {{"front", "back"}, {"left", "right"}, {"up", "down"}}};
  return kSides[static_cast<std::size_t>(largest - position.begin())][*largest > 0 ? 0 : 1];
}

class OtherBall : public testing::TestWithParam<Ball> {
 protected:
  void start(const std::string& device) {
    home_.write("config/hedgehog/devices.d/truth.json", file_of(GetParam()));
    home_.configure(R"({"device": ")" + device + R"(", "simulator": {"device": "truth"}})");
  }
  Home home_;
};

TEST_P(OtherBall, IsIdentifiedAndThenPushesInTheRequestedDirection) {
  const Ball& ball = GetParam();
  start("hedgehog-86");
  {
    DaemonProcess daemon(home_, {"--speed", "3"});
    RawClient hand(daemon.port());
    EXPECT_EQ("x=" + felt(hand, {1, 0, 0}, "coil", 0.6) + ",y=" +
                  felt(hand, {0, 1, 0}, "coil", 0.6) + ",z=" + felt(hand, {0, 0, 1}, "coil", 0.6),
              ball.pushed);
    const Ended ended =
        Program(home_, hedgehogctl(),
                {"calibrate", "--out", home_.path("found.json"), "--pushed", ball.pushed},
                {"HEDGEHOG_ADDRESS=" + daemon.socket()})
            .wait();
    ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
    EXPECT_EQ(daemon.stop(), 0);
  }
  const Json found = Json::parse(home_.read("found.json"), nullptr, true, true);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(found["r25_ohm"][i].get<double>() / ball.r25_ohm[i], 1.0, 0.01) << i;
  EXPECT_NEAR(found["inductance_h"].get<double>() / ball.inductance_h, 1.0, 0.03);
  EXPECT_EQ(found["coil_matrix"], Json::parse(ball.matrix));

  start("../../found.json");
  DaemonProcess daemon(home_);
  RawClient hand(daemon.port());
  for (const std::string side : {"front", "back", "left", "right", "up", "down"})
    EXPECT_EQ(felt(hand, side, "device", 5.0), side);
  EXPECT_EQ(felt(hand, "left", "device", 15.0), "left") << "a burst is no fault";
}

constexpr Ball kBalls[] = {
    {"SwappedLeads",
     {0.45, 0.45, 0.45},
     0.0015,
     "[[0,1,0],[1,0,0],[0,0,1]]",
     "x=left,y=front,z=up"},
    {"TwentyPercent",
     {0.36, 0.54, 0.45},
     0.0019,
     "[[1,0,0],[0,1,0],[0,0,-1]]",
     "x=front,y=left,z=down"},
    {"Beyond", {0.22, 0.90, 0.45}, 0.0010, "[[0,0,-1],[1,0,0],[0,-1,0]]", "x=down,y=front,z=right"},
};
INSTANTIATE_TEST_SUITE_P(Balls, OtherBall, testing::ValuesIn(kBalls),
                         [](const auto& one) { return one.param.name; });

class Bringup : public testing::Test {
 protected:
  void start(const std::string& device) {
    home_.write("config/hedgehog/devices.d/truth.json", device);
    home_.configure(R"({"simulator": {"device": "truth"}})");
    daemon_.emplace(home_, std::vector<std::string>{"--speed", "2"});
  }
  std::vector<std::string> words() const {
    return {"calibrate", "--out", home_.path("found.json")};
  }
  std::vector<std::string> where() const { return {"HEDGEHOG_ADDRESS=" + daemon_->socket()}; }
  Home home_;
  std::optional<DaemonProcess> daemon_;
};

TEST_F(Bringup, APersonIsPromptedUntilTheAnswersAreConsistent) {
  start(R"({"coil_matrix": [[0, 1, 0], [1, 0, 0], [0, 0, 1]]})");
  TerminalProgram screen(home_, hedgehogctl(), words(), where());
  RawClient hand(daemon_->port());
  hand.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_started"}}});
  // After the measurement of the windings.
  ASSERT_TRUE(screen.shows("Enter when you hold it: ", kLongTimeout)) << screen.shown();
  screen.type("\r");
  const auto answer = [&](const std::string& text, const std::string& then) {
    screen.type(text + "\r");
    ASSERT_TRUE(screen.shows(then)) << screen.shown();
  };
  ASSERT_TRUE(screen.shows("x pushes now, where? "));
  answer("lft", "\"lft\" is no side.");
  answer("", "x pushes now, where? ");
  answer("left", "y pushes now, where? ");
  answer("r", "x left and y right are on one axis, but each winding has its own. Feel again:");
  answer("LEFT", "y pushes now, where? ");
  answer("f", "z pushes now, where? ");
  answer("up", "That is left-handed: two windings are swapped, or one is the other way round.");
  EXPECT_EQ(screen.wait(), 0) << screen.shown();
  const Json found = Json::parse(home_.read("found.json"), nullptr, true, true);
  EXPECT_EQ(found["coil_matrix"], Json::parse("[[0,1,0],[1,0,0],[0,0,1]]"));
  std::istringstream lines(screen.shown());
  for (std::string line; std::getline(lines, line);) {
    const auto columns = std::count_if(line.begin(), line.end(), [](char c) {
      return c != '\r' && (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    });
    if (line.starts_with("wrote ")) continue;  // a path may have any length
    EXPECT_LE(columns, 80) << line;
  }
}

TEST_F(Bringup, SidesAreNotPromptedForBeforeTheResistancesAreRight) {
  start(R"({"r25_ohm": [0.45, 0.9, 0.45]})");
  TerminalProgram screen(home_, hedgehogctl(), words(), where());
  EXPECT_EQ(screen.wait(), 0) << screen.shown();
  EXPECT_THAT(screen.shown(), HasSubstr("The present device file has 0.4500"));
  EXPECT_THAT(screen.shown(), HasSubstr("Start hedgehogd with the new file, then calibrate"));
}

TEST_F(Bringup, TripsAtLowCurrentAreReportedWithARemedy) {
  start(R"({"r25_ohm": [0.45, 0.08, 0.45]})");
  const Ended ended = Program(home_, hedgehogctl(), words(), where()).wait();
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.err, HasSubstr("current_mismatch"));
  EXPECT_THAT(ended.err, HasSubstr("winding y was driven with 0.3 A"));
  EXPECT_THAT(ended.err, HasSubstr("measure it by hand, write it there (r25_ohm)"));
  EXPECT_EQ(home_.read("found.json"), "");
}

TEST_F(Bringup, AGainThatReducesTheCurrentsIsReported) {
  start("{}");
  RawClient(daemon_->port()).call("output.set_gain", {{"gain", 0.5}});
  const Ended ended = Program(home_, hedgehogctl(), words(), where()).wait();
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.err, HasSubstr("the gain is 0.50"));
  EXPECT_THAT(ended.err, HasSubstr("hedgehogctl gain 1"));
}

TEST_F(Bringup, TheBoardProcessHasTheTrueBallToo) {
  home_.write("config/hedgehog/devices.d/truth.json", R"({"r25_ohm": [0.45, 0.9, 0.45]})");
  home_.configure(R"({"simulator": {"device": "truth", "process": true}})");
  daemon_.emplace(home_, std::vector<std::string>{}, std::vector<std::string>{},
                  DaemonProcess::Backend::kFree);
  RawClient hand(daemon_->port());
  hand.call("telemetry.subscribe", {{"rate_hz", 50}, {"fields", {"current_a"}}});
  double flows_a = 0.0;
  const auto halved = [&] {
    // On a busy machine the ball, and with it the hold, may be lost.
    if (!arms(hand)) return false;
    renew_hold(hand, {{"direction", "left"}, {"current_a", 1.2}});
    flows_a = hand.notification("telemetry")["current_a"][1];
    return std::abs(flows_a - 0.6) < 0.03;
  };
  EXPECT_TRUE(eventually(halved)) << flows_a;
}

}  // namespace
}  // namespace hedgehog::e2e

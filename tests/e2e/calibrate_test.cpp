// SPDX-License-Identifier: MIT
// hedgehogctl calibrate against a live daemon whose simulated ball is not the default one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <functional>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kUnequalBall = R"({"name": "odd", "r25_ohm": [0.400, 0.520, 0.463],
  "inductance_h": 0.0021, "force_slope_n_a": 0.0131, "limits": {"current_a": 12}})";

class Calibrate : public testing::Test {
 protected:
  void SetUp() override {
    home_.configure(R"({"device": "odd"})");
    home_.write("config/hedgehog/devices.d/odd.json", kUnequalBall);
  }
  /// `while_running` is called repeatedly.
  Ended calibrate(
      const DaemonProcess& daemon, std::vector<std::string> more,
      const std::function<void()>& while_running = [] {}) const {
    more.insert(more.begin(), {"calibrate", "--out", home_.path("found.json")});
    Program program(home_, hedgehogctl(), more, {"HEDGEHOG_ADDRESS=" + daemon.socket()});
    return wait_renewing(program, while_running);
  }
  Home home_;
};

TEST_F(Calibrate, FindsTheSimulatedWindingsAndWritesAFileThatTheDaemonReads) {
  DaemonProcess daemon(home_, {"--speed", "4"});
  const Ended ended = calibrate(daemon, {"--name", "ball-7", "--pushed", "x=front,y=left,z=down"});
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  const Json file = Json::parse(home_.read("found.json"), nullptr, true, true);
  EXPECT_EQ(file["name"], "ball-7");
  EXPECT_EQ(file["arrangement"], "tkD-86");
  constexpr std::array<double, 3> kOhm{0.400, 0.520, 0.463};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(file["r25_ohm"][i].get<double>(), kOhm[i], 0.005 * kOhm[i]) << i;
  EXPECT_NEAR(file["inductance_h"].get<double>(), 0.0021, 0.03 * 0.0021);
  EXPECT_EQ(file["coil_matrix"], Json::parse("[[1,0,0],[0,1,0],[0,0,-1]]"));
  EXPECT_EQ(file["force_slope_n_a"], 0.0131);
  EXPECT_EQ(file["limits"]["current_a"], 12);
  EXPECT_EQ(file["thermal"]["core_j_k"], 84.4) << "not measured: as it was";
  EXPECT_EQ(file["uncertainty"],
            (Json{{"thermal", 0.2}, {"resistance", 0.01}, {"thermistor_k", 0.5}}));
  EXPECT_EQ(daemon.stop(), 0);

  home_.configure(R"({"device": "../../found.json"})");
  const Ended checked = run_daemon(home_, {"--check-config"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
}

TEST_F(Calibrate, ReplacesNoFileWithoutForce) {
  DaemonProcess daemon(home_);
  home_.write("found.json", "mine");
  const Ended ended = calibrate(daemon, {});
  EXPECT_EQ(ended.exit_code, 73);
  EXPECT_THAT(ended.err, HasSubstr("--force replaces it"));
  EXPECT_EQ(home_.read("found.json"), "mine");
  EXPECT_EQ(calibrate(daemon, {"--force", "--pushed", "x=up,y=down"}).exit_code, 64);
}

TEST_F(Calibrate, AWarmBallIsRefusedUnlessForcedAndThenHasAWideUncertainty) {
  DaemonProcess daemon(home_, {"--speed", "4"});
  RawClient hand(daemon.port());
  hand.call("events.subscribe", {{"types", {"effect_ended"}}});
  hand.call("effect.pulse", {{"direction", "left"}, {"current_a", 12}, {"duration_ms", 8000}});
  hand.notification("event", "effect_ended");
  const Ended refused = calibrate(daemon, {});
  EXPECT_EQ(refused.exit_code, 75);
  EXPECT_THAT(refused.err, HasSubstr("not at one temperature: winding y is "));
  EXPECT_THAT(refused.err, HasSubstr("K warmer than the thermometer"));
  EXPECT_THAT(refused.err, HasSubstr("Let the ball rest for "));
  EXPECT_EQ(home_.read("found.json"), "");

  const Ended forced = calibrate(daemon, {"--force"});
  ASSERT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_THAT(forced.out, HasSubstr("Forced: the ball is not at one temperature"));
  const std::string text = home_.read("found.json");
  EXPECT_THAT(text, HasSubstr("// Forced: "));
  EXPECT_GT(Json::parse(text, nullptr, true, true)["uncertainty"]["resistance"], 0.03);
}

TEST_F(Calibrate, CtrlCStopsTheCurrents) {
  DaemonProcess daemon(home_);
  Program running(home_, hedgehogctl(), {"calibrate", "--out", home_.path("found.json")},
                  {"HEDGEHOG_ADDRESS=" + daemon.socket()});
  RawClient watcher(daemon.port());
  watcher.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_started"}}});
  watcher.notification("event", "effect_started");
  running.signal(SIGINT);
  EXPECT_EQ(running.wait().exit_code, 130);
  // The daemon may detect the end of the connection a moment later.
  EXPECT_TRUE(eventually([&] { return watcher.call("device.status")["effects"].empty(); }));
  EXPECT_EQ(home_.read("found.json"), "");
}

TEST_F(Calibrate, ADisarmedBallIsNotMeasured) {
  DaemonProcess daemon(home_);
  RawClient(daemon.port()).call("device.emergency_stop");
  const Ended ended = calibrate(daemon, {});
  EXPECT_EQ(ended.exit_code, 69);
  EXPECT_THAT(ended.err, HasSubstr("the ball is disarmed: emergency_stop"));
  EXPECT_THAT(ended.err, HasSubstr("hedgehogctl arm"));
  EXPECT_THAT(ended.err, Not(HasSubstr("r25_ohm")));
}

TEST_F(Calibrate, AClaimedBallIsNotMeasured) {
  DaemonProcess daemon(home_);
  RawClient other(daemon.port());
  const Ended ended = calibrate(daemon, {}, [&] { other.call("device.claim"); });
  EXPECT_EQ(ended.exit_code, 75);
  EXPECT_THAT(ended.err, HasSubstr("another client has exclusive use of the ball"));
  EXPECT_THAT(ended.err, Not(HasSubstr("r25_ohm")));
  EXPECT_EQ(home_.read("found.json"), "");
}

}  // namespace
}  // namespace hedgehog::e2e

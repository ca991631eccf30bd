// SPDX-License-Identifier: MIT
// hedgehogctl calibrate --thermal against a live daemon: interrupted, continued, and, since half an
// hour is too long for a test, completed with samples of a ball that was heated in virtual time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"
#include "tests/rig/heated_ball.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

class CalibrateThermal : public testing::Test {
 protected:
  Ended interrupted_after(const std::string& shown, std::vector<std::string> more) const {
    Program running(home_, hedgehogctl(), words(std::move(more)), where());
    // Preceded by a minute of the ball's time.
    EXPECT_TRUE(
        wait_until([&] { return running.out().find(shown) != std::string::npos; }, kLongTimeout));
    running.signal(SIGINT);
    return running.wait();
  }
  std::vector<std::string> words(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"calibrate", "--thermal", "--out", home_.path("found.json")});
    return more;
  }
  std::vector<std::string> where() const { return {"HEDGEHOG_ADDRESS=" + daemon_.socket()}; }
  std::string progress() const { return home_.read("found.json.progress"); }

  Home home_;
  // calibrate rejects a gap of a second of device time in the telemetry: faster, a busy machine has
  // some.
  DaemonProcess daemon_{home_, {"--speed", "2"}};
};

/// The lines of a progress file with all samples of `ball`.
std::string all_samples(const model::PlantParameters& ball) {
  model::HeatedBall heated(ball, {}, 25.0, 1);
  std::string lines;
  std::size_t step = 0;
  for (const model::HeatingStep& one : model::heating_plan()) {
    const model::HeatSample s = heated.step(one);
    const Json line{{"run", 0},
                    {"at_rest", true},
                    {"step", step++},
                    {"dt_s", s.dt_s},
                    {"end_s", s.end_s},
                    {"power_w", s.power_w},
                    {"voltage_v", s.voltage_v},
                    {"current_a", s.current_a},
                    {"count", s.count},
                    {"fan", s.fan_running},
                    {"sensor_c", *s.sensor_c}};
    lines += line.dump() + "\n";
  }
  return lines;
}

TEST_F(CalibrateThermal, ContinuesAfterAnInterruptionAndWritesItsResult) {
  const Ended first = interrupted_after("of 30: at rest", {});
  EXPECT_EQ(first.exit_code, 130) << first.err;
  EXPECT_THAT(first.err, HasSubstr("Repeat the command to resume from"));
  EXPECT_EQ(home_.read("found.json"), "") << "nothing half done";
  const std::string begun = progress();
  EXPECT_THAT(begun, HasSubstr("\"power_w\""));

  const Ended second = interrupted_after("\"phase\":", {"--json"});
  EXPECT_EQ(second.exit_code, 130) << second.err;
  EXPECT_THAT(second.err, HasSubstr("eating and cooling for 30 minutes"));
  EXPECT_EQ(progress().substr(0, begun.find('\n')), begun.substr(0, begun.find('\n')))
      << "the windings were not measured again";

  model::PlantParameters ball;
  ball.winding_j_k = {50.0, 66.0, 60.0};
  ball.core_to_ambient_fan_k_w = 2.0;
  ball.sensor_winding = 1;
  home_.write("found.json.progress", begun.substr(0, begun.find('\n') + 1) + all_samples(ball));
  const Ended ended = Program(home_, hedgehogctl(), words(), where()).wait();
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("The thermometer is on winding y"));
  EXPECT_EQ(progress(), "");
  const Json file = Json::parse(home_.read("found.json"), nullptr, true, true);
  EXPECT_NEAR(file["thermal"]["winding_j_k"][0].get<double>(), 50.0, 0.05 * 50.0);
  EXPECT_NEAR(file["thermal"]["winding_j_k"][1].get<double>(), 66.0, 0.05 * 66.0);
  EXPECT_NEAR(file["thermal"]["core_to_room_fan_k_w"].get<double>(), 2.0, 0.1);
  EXPECT_EQ(file["thermal"]["sensor_winding"], 1);
  EXPECT_LT(file["uncertainty"]["thermal"], 0.1);
  home_.configure(R"({"device": "../../found.json"})");
  EXPECT_EQ(run_daemon(home_, {"--check-config"}).exit_code, 0);
}

TEST_F(CalibrateThermal, AForeignProgressFileIsNotContinued) {
  home_.write("found.json.progress", "something else");
  const Ended ended = Program(home_, hedgehogctl(), words(), where()).wait();
  EXPECT_EQ(ended.exit_code, 65);
  EXPECT_THAT(ended.err, HasSubstr("it is damaged. Remove it to start over"));
  EXPECT_EQ(progress(), "something else");
}

}  // namespace
}  // namespace hedgehog::e2e

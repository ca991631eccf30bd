// SPDX-License-Identifier: MIT
// Sound files played by hedgehogctl on a daemon, and rotations of the ball recorded as patterns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/clients/wav_sample.h"
#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/exit_codes.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using client::click;
using client::sine;
using testing::HasSubstr;

class SoundPlay : public testing::Test {
 protected:
  SoundPlay() { other_.call("events.subscribe", {{"scope", "all"}}); }
  std::vector<std::string> variables() const { return {"HEDGEHOG_ADDRESS=" + daemon_.socket()}; }
  std::string file(double seconds, const std::function<std::pair<double, double>(double)>& sound) {
    home_.write("sound.wav", client::wav_of(seconds, sound));
    return home_.path("sound.wav");
  }
  Ended ctl(const std::vector<std::string>& arguments) {
    return Program(home_, hedgehogctl(), arguments, variables()).wait();
  }

  Home home_;
  // In lock-step: when the daemon stalls, the time of the ball stops too. Otherwise an effect then
  // begins late and, played in full, overlaps the next one.
  DaemonProcess daemon_{home_, {"--speed", "1"}};
  RawClient other_{daemon_.port()};
};

TEST_F(SoundPlay, ALowToneIsPlayedToItsEndWithoutGapsOnItsSide) {
  const std::string hum = file(2.0, [](double t) { return std::pair(0.5 * sine(t, 40.0), 0.0); });
  const Ended ended = ctl({"--json", "play", hum, "--pulses", "0"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  std::istringstream lines(ended.out);
  std::vector<Json> responses;
  for (std::string line; std::getline(lines, line);) responses.push_back(Json::parse(line));
  ASSERT_EQ(responses.size(), 5u) << "four slices, and what was played";
  EXPECT_EQ(responses.back()["late_slices"], 0);
  EXPECT_EQ(responses.back()["reason"], "completed");
  std::vector<Json> ends;
  while (ends.size() < 4) ends.push_back(other_.notification("event", "effect_ended"));
  for (std::size_t i = 1; i < ends.size(); ++i) {
    EXPECT_EQ(ends[i]["reason"], "completed");
    EXPECT_EQ(ends[i]["onset_ns"], ends[i - 1]["offset_ns"]) << "seamless";
  }
  for (const Json& response : responses)
    if (response.contains("pin")) EXPECT_EQ(response["pin"], 34) << "the left";
}

TEST_F(SoundPlay, PreviewPrintsWhatWouldBeSent) {
  const std::string clicks =
      file(1.0, [](double t) { return std::pair(click(t, 0.2), click(t, 0.7)); });
  const Ended ended = ctl({"--json", "preview", "play", clicks, "--vibration", "0"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  std::istringstream lines(ended.out);
  std::vector<Json> slices;
  for (std::string line; std::getline(lines, line);) slices.push_back(Json::parse(line));
  ASSERT_EQ(slices.size(), 2u);
  EXPECT_NEAR(slices[0]["keyframes"][0]["t_ms"].get<double>(), 200.0, 10.0);
  EXPECT_EQ(slices[0]["keyframes"][0]["direction"]["azimuth_deg"], 90);
  EXPECT_EQ(slices[1]["at_ms"], 500);
  EXPECT_NEAR(slices[1]["keyframes"][0]["t_ms"].get<double>(), 200.0, 10.0);
  EXPECT_EQ(slices[1]["keyframes"][0]["direction"]["azimuth_deg"], -90);
  EXPECT_THAT(ctl({"preview", "play", clicks}).out, HasSubstr("left"));
}

TEST_F(SoundPlay, EndsWithCtrlCAndWithTheProgram) {
  const std::string hum = file(60.0, [](double t) { return std::pair(sine(t, 50.0), 0.0); });
  {
    Program program(home_, hedgehogctl(), {"play", hum}, variables());
    other_.notification("event", "effect_started");
    program.signal(SIGINT);
    EXPECT_EQ(program.wait().exit_code, kInterrupted);
    // Slices that ended before the program handled the signal are complete.
    std::string reason;
    do reason = other_.notification("event", "effect_ended")["reason"];
    while (reason == "completed");
    EXPECT_EQ(reason, "disconnected");
  }
  ASSERT_TRUE(eventually([&] { return other_.call("device.status")["effects"].empty(); }));
  Program program(home_, hedgehogctl(), {"play", hum}, variables());
  ASSERT_TRUE(eventually([&] { return !other_.call("device.status")["effects"].empty(); }));
  program.signal(SIGKILL);
  EXPECT_TRUE(eventually([&] { return other_.call("device.status")["effects"].empty(); }));
}

TEST_F(SoundPlay, OptionsThatDoNotApplyToASoundFileAreRefused) {
  const std::string hum = file(0.5, [](double t) { return std::pair(sine(t, 50.0), 0.0); });
  EXPECT_EQ(ctl({"play", hum, "--loop"}).exit_code, kUsage);
  EXPECT_EQ(ctl({"play", hum, "--duration-ms", "100"}).exit_code, kUsage);
  EXPECT_EQ(ctl({"play", home_.path("none.wav")}).exit_code, kNoInput);
  home_.write("text.wav", "no sound");
  EXPECT_EQ(ctl({"play", home_.path("text.wav")}).exit_code, kBadData);
}

TEST_F(SoundPlay, ATurnOfTheBallBecomesAPatternThatPlaysTheSameWay) {
  constexpr double kDegree = 3.14159265358979 / 180.0;
  Program program(home_, hedgehogctl(),
                  {"--json", "record", home_.path("turn.json"), "--seconds", "2"}, variables());
  ASSERT_TRUE(
      eventually([&] { return other_.call("connection.list")["connections"].size() == 2; }));
  const auto now_s = [&] { return other_.call("ping")["time_ns"].get<double>() * 1e-9; };
  const double start_s = now_s();
  while (!has_ended(program)) {
    const double yaw = 90.0 * kDegree * std::clamp(now_s() - start_s - 0.3, 0.0, 1.0);
    other_.call(
        "sim.set",
        {{"orientation",
          {{"w", std::cos(0.5 * yaw)}, {"x", 0.0}, {"y", 0.0}, {"z", std::sin(0.5 * yaw)}}}});
  }
  const Ended ended = program.wait();
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Json printed = Json::parse(ended.out);
  EXPECT_LE(printed["error_deg"].get<double>(), 2.0);
  const Json pattern = Json::parse(home_.read("turn.json"));
  EXPECT_EQ(pattern["name"], "recorded/path");
  EXPECT_GE(pattern["keyframes"].size(), 2u);
  const Json preview = other_.call(
      "effect.preview", {{"method", "effect.play"},
                         {"params", {{"keyframes", pattern["keyframes"]}, {"current_a", 5}}}});
  ASSERT_TRUE(preview.contains("current_a")) << preview;
  const Json& currents = preview["current_a"];
  EXPECT_GT(currents.front()[0].get<double>(), 4.9) << "it began at the front";
  EXPECT_GT(currents[currents.size() - 2][1].get<double>(), 4.9) << "and went to the left";
  EXPECT_EQ(ctl({"record", home_.path("turn.json")}).exit_code, kCannotCreate);
}

}  // namespace
}  // namespace hedgehog::e2e

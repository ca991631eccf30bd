// SPDX-License-Identifier: MIT
// The exact status output for a person.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "clients/ctl/screen/ball_map.h"
#include "clients/ctl/screen/status_screen.h"
#include "clients/ctl/terminal/bar.h"
#include "clients/ctl/terminal/words.h"
#include "tests/clients/warm_ball.h"

namespace hedgehog::client {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::size_t marks(const std::vector<std::string>& lines, const std::string& mark) {
  std::size_t count = 0;
  for (std::size_t row = 1; row + 1 < lines.size(); ++row)
    for (std::size_t at = lines[row].find(mark); at != std::string::npos;
         at = lines[row].find(mark, at + mark.size()))
      ++count;
  return count;
}

TEST(BallMap, HasOneRowPerRingAndOneMarkPerPin) {
  const auto lines = ball_map(model::thesis_ball().array, forces_of({}), {});
  ASSERT_EQ(lines.size(), 10u);
  EXPECT_EQ(marks(lines, "·"), 86u);
}

TEST(BallMap, ShowsAPushToTheLeftOnTheLeft) {
  const auto lines =
      ball_map(model::thesis_ball().array, forces_of({0, 15, 0}), {true, std::nullopt});
  for (std::size_t row = 2; row < 9; ++row) {
    const std::size_t strongest = lines[row].find('@');
    if (strongest != std::string::npos) EXPECT_LT(lines[row].rfind('@'), 39u) << lines[row];
  }
  EXPECT_GT(marks(lines, "@"), 10u);
}

TEST(BallMap, ShowsAPushUpOnTop) {
  const auto lines =
      ball_map(model::thesis_ball().array, forces_of({0, 0, 15}), {true, std::nullopt});
  EXPECT_EQ(lines[1], std::string(39, ' ') + "@");
  EXPECT_EQ(marks({"", lines[8], ""}, "@"), 0u);
}

TEST(BallMap, MarksTheWorldsUp) {
  const auto lines =
      ball_map(model::thesis_ball().array, forces_of({}), {true, model::Vec3{1, 0, 0}});
  EXPECT_EQ(marks(lines, "^"), 1u);
}

RC_GTEST_PROP(BallMap, FitsEightyColumns, ()) {
  const auto part = [] { return *rc::gen::inRange(-150, 151) / 10.0; };
  const auto lines = ball_map(model::thesis_ball().array, forces_of({part(), part(), part()}), {});
  for (const std::string& line : lines) RC_ASSERT(columns(line) <= 79u);
}

TEST(Bar, FillsFromTheLeft) {
  EXPECT_EQ(bar(0.0, 0.0, 26.0, {}, true), std::string(26, '-'));
  EXPECT_EQ(bar(13.0, 0.0, 26.0, {}, true), std::string(13, '=') + std::string(13, '-'));
  EXPECT_EQ(bar(99.0, 0.0, 26.0, {}, true), std::string(26, '='));
}

TEST(Bar, ShowsItsMarksFilledOrNot) {
  const std::array marks{10.0};
  EXPECT_EQ(bar(0.0, 0.0, 26.0, marks, true)[9], '|');
  EXPECT_EQ(columns(bar(26.0, 0.0, 26.0, marks, false)), 26u);
}

TEST(Words, FormatNumbersForPeople) {
  EXPECT_EQ(fixed_signed(4.96, 1), "+5.0");
  EXPECT_EQ(fixed_signed(-0.04, 1), "0.0");
  EXPECT_EQ(fixed_signed(-0.26, 1), "-0.3");
  EXPECT_EQ(time_words(1.5), "1.5 s");
  EXPECT_EQ(time_words(12.3), "12 s");
  EXPECT_EQ(time_words(200), "3 min 20 s");
  EXPECT_EQ(time_words(33'120), "9 h 12 min");
  EXPECT_EQ(time_words(273'600), "3 d 4 h");
  EXPECT_EQ(headroom_words(std::nullopt), "for ever");
}

TEST(Words, ShowAnUnknownTemperatureWithoutANumber) {
  EXPECT_EQ(temperature_words(61.24), "61.2 °C");
  EXPECT_EQ(temperature_words({}), "temperature unknown");
}

TEST(Words, TruncateByCharactersNotBytes) {
  EXPECT_EQ(cut("°°°°", 4), "°°°°");
  EXPECT_EQ(cut("°°°°", 3), "°°…");
}

TEST(StatusScreen, ShowsAllFieldsInEightyColumns) {
  const auto lines = status_screen(warm_ball(), {});
  for (const std::string& line : lines) EXPECT_LE(columns(line), 80u) << line;
  EXPECT_THAT(lines[0], StartsWith("  ball-7 · armed"));
  EXPECT_THAT(lines[0], EndsWith("hedgehogd 1.0.0, up 3 d 4 h, USB"));
  EXPECT_THAT(lines, testing::Contains(StartsWith("  temperature    41.6 °C  ━━━━━━━━━")));
  EXPECT_THAT(lines, testing::Contains(EndsWith("of 15.0 A allowed")));
  EXPECT_THAT(lines, testing::Contains("  force          0.062 N  at pin 33, left"));
  EXPECT_THAT(lines, testing::Contains(
                         "  headroom      for ever  at this current; 15 A for 11 s, then less"));
  EXPECT_THAT(lines, testing::Contains(
                         "  orientation   3 ms old  tilted 12° left, 4° forward, heading 0°"));
}

TEST(StatusScreen, ColoursTheStateAndTruncatesNothingInAPipe) {
  const ScreenStyle coloured{.colour = true};
  Ball ball = warm_ball();
  EXPECT_THAT(live_title(ball.status, coloured), HasSubstr("\033[32marmed\033[0m"));
  ball.status.derating = true;
  EXPECT_THAT(live_title(ball.status, coloured), HasSubstr("\033[33marmed\033[0m"));
  ball.status.state = "tripped";
  EXPECT_THAT(live_title(ball.status, coloured), HasSubstr("\033[31mTRIPPED\033[0m"));
  const std::string name = "A game with a name of more than twenty-four characters";
  ball.status.effects[0].client = name;
  EXPECT_THAT(status_screen(ball, {.cuts = false}), testing::Contains(EndsWith(name)));
  EXPECT_THAT(status_screen(ball, {}), testing::Contains(EndsWith("…")));
}

TEST(StatusScreen, ShowsTheHottestWindingFirstAndNamesTheThermistor) {
  const auto lines = status_screen(hot_ball(), {});
  for (const std::string& line : lines) EXPECT_LE(columns(line), 80u) << line;
  EXPECT_THAT(lines[2], StartsWith("  temperature    66.1 °C  ━━━━━━━━━"));
  EXPECT_THAT(lines[2], EndsWith("derates at 60, trips at 70"));
  EXPECT_EQ(lines[3], "               winding y  the hottest; x 40.8 °C, z 38.4 °C");
  EXPECT_EQ(lines[4], "  thermistor     38.3 °C  on winding z, 3 ms old");
}

TEST(StatusScreen, ASilentThermistorIsReported) {
  Ball ball = hot_ball();
  ball.status.temperature_c.sensor.reset();
  ball.status.temperature_c.age_ms = 1500;
  EXPECT_THAT(status_screen(ball, {}),
              testing::Contains("  thermistor     unknown  on winding z, silent for 1.5 s"));
  ball.status.temperature_c.age_ms.reset();
  EXPECT_THAT(status_screen(ball, {}),
              testing::Contains("  thermistor     unknown  on winding z, never read"));
}

TEST(StatusScreen, ShowsTheReasonOfATripAndItsRemedy) {
  Ball ball = warm_ball();
  ball.status.state = "tripped";
  ball.status.reason = "sensor_frozen";
  ball.status.remedy = "Mend the thermometer's plug, then run: hedgehogctl arm";
  const auto lines = status_screen(ball, {});
  EXPECT_THAT(lines[0], HasSubstr("TRIPPED: sensor_frozen"));
  EXPECT_THAT(lines[2], HasSubstr("hedgehogctl arm"));
  EXPECT_THAT(lines, testing::Contains(EndsWith("of 0.0 A allowed")));
  EXPECT_THAT(lines, testing::Contains("  headroom          none  no current is allowed"));
}

TEST(StatusScreen, NamesTheMeasurementsThatContradictedEachOther) {
  Ball ball = warm_ball();
  ball.status.last_trip = protocol::TripStatus{.reason = "overheated"};
  ball.status.last_trip->disagreement = {1, {"current", "supply_current"}};
  EXPECT_THAT(status_screen(ball, {}),
              testing::Contains(EndsWith("ago: overheated (winding y: current, supply_current)")));
  ball.status.last_trip->disagreement = {3, {"current"}};
  EXPECT_THAT(status_screen(ball, {}), testing::Contains(EndsWith("ago: overheated")));
}

TEST(StatusScreen, ShowsNoUnknownTemperature) {
  Ball ball = warm_ball();
  ball.status.temperature_c.thermometer = 38.04;
  EXPECT_THAT(status_screen(ball, {}),
              testing::Contains(testing::AllOf(HasSubstr("thermometer"), HasSubstr("38.0 °C"))));
  ball.status.temperature_c = {.sensor = 38.3};
  EXPECT_THAT(status_screen(ball, {})[2], StartsWith("  temperature    unknown  "))
      << "the thermistor is on one winding";
  ball.status.headroom_s = 0.0;
  EXPECT_THAT(
      status_screen(ball, {}),
      testing::Contains("  headroom       unknown  no current is allowed until the temperature is "
                        "known"));
}

}  // namespace
}  // namespace hedgehog::client

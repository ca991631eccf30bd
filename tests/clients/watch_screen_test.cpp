// SPDX-License-Identifier: MIT
// `hedgehogctl watch`: the live status in the terminal's size, and the newest events.
#include "clients/ctl/screen/watch_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "clients/ctl/terminal/words.h"
#include "tests/clients/warm_ball.h"

namespace hedgehog::client {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

using testing::AllOf;
using testing::Contains;

constexpr std::int64_t kSecondNs = 1'000'000'000;

protocol::Event event_at(std::int64_t second, const std::string& type) {
  return {.type = type, .time_ns = second * kSecondNs};
}

protocol::Event overrun_at(std::int64_t second) {
  protocol::Event event = event_at(second, "overrun");
  event.skipped = 30;
  return event;
}

protocol::Event changed_at(std::int64_t second, const std::string& state,
                           const std::string& reason) {
  protocol::Event event = event_at(second, "state_changed");
  event.state = state;
  event.reason = reason;
  return event;
}

/// "14:00:07"
std::string clock_at(std::int64_t second) {
  const std::string text = std::to_string(1'000'000 + second / 60 * 100 + second % 60);
  return "14:" + text.substr(3, 2) + ":" + text.substr(5, 2);
}

void take(WatchScreen& screen, const protocol::Event& event) {
  screen.take(event, clock_at(event.time_ns / kSecondNs));
}

TEST(WatchEvents, OverrunsOfTwoMinutesAreOneLine) {
  WatchScreen screen({});
  take(screen, changed_at(1, "disarmed", "emergency_stop"));
  for (std::int64_t second = 2; second <= 121; ++second) take(screen, overrun_at(second));
  const auto lines = screen.lines(warm_ball());
  EXPECT_EQ(lines.end()[-2], "  14:02:01  overrun  3600 ticks skipped, 120 times since 14:00:02");
  EXPECT_EQ(lines.back(), "  14:00:01  state_changed  disarmed: emergency_stop");
}

TEST(WatchEvents, OrientationLossesAndRestorationsAreOneLineEach) {
  WatchScreen screen({});
  take(screen, changed_at(1, "tripped", "overheated"));
  for (std::int64_t second = 2; second < 60; second += 2) {
    take(screen, event_at(second, "orientation_lost"));
    take(screen, event_at(second + 1, "orientation_restored"));
  }
  const auto lines = screen.lines(warm_ball());
  EXPECT_EQ(lines.end()[-3], "  14:00:59  orientation_restored, 29 times since 14:00:03");
  EXPECT_EQ(lines.end()[-2], "  14:00:58  orientation_lost, 29 times since 14:00:02");
  EXPECT_EQ(lines.back(), "  14:00:01  state_changed  tripped: overheated");
}

TEST(WatchEvents, AfterAMinuteWithoutOneASeriesIsOver) {
  WatchScreen screen({});
  take(screen, overrun_at(0));
  take(screen, overrun_at(60));
  take(screen, overrun_at(121));
  const auto lines = screen.lines(warm_ball());
  EXPECT_EQ(lines.end()[-2], "  14:02:01  overrun  30 ticks skipped");
  EXPECT_EQ(lines.back(), "  14:01:00  overrun  60 ticks skipped, 2 times since 14:00:00");
}

TEST(WatchEvents, ASeriesLastsAnHourAtMost) {
  WatchScreen screen({});
  for (std::int64_t second = 0; second <= 3630; second += 30) take(screen, overrun_at(second));
  const auto lines = screen.lines(warm_ball());
  EXPECT_THAT(lines.back(), HasSubstr("3630 ticks skipped, 121 times since 14:00:00"));
  EXPECT_THAT(lines.end()[-2], EndsWith("  overrun  30 ticks skipped"));
}

/// Independent of other events, before or after.
TEST(WatchEvents, ATripAStopAndADeratingAreNotDisplacedByEffects) {
  for (const char* state : {"tripped", "disarmed", "absent"}) {
    WatchScreen screen({});
    take(screen, changed_at(1, state, "a_reason"));
    take(screen, event_at(2, "derating_started"));
    take(screen, changed_at(3, "armed", "a_reason"));
    for (std::int64_t second = 4; second < 50; ++second) {
      take(screen, event_at(second, "effect_started"));
      take(screen, event_at(second, "effect_ended"));
    }
    const auto lines = screen.lines(warm_ball());
    EXPECT_EQ(lines.end()[-3], "  14:00:49  effect_ended") << state;
    EXPECT_EQ(lines.end()[-2], "  14:00:02  derating_started") << state;
    EXPECT_EQ(lines.back(), "  14:00:01  state_changed  " + std::string(state) + ": a_reason");
  }
}

TEST(WatchEvents, DeratingAndATripDoNotDisplaceEachOther) {
  WatchScreen screen({});
  take(screen, changed_at(1, "tripped", "overheated"));
  for (std::int64_t second = 2; second < 30; ++second)
    take(screen, event_at(second, second % 2 == 0 ? "derating_started" : "derating_ended"));
  EXPECT_THAT(screen.lines(warm_ball()).back(), HasSubstr("tripped: overheated"));
  for (std::int64_t second = 30; second < 60; ++second)
    take(screen, changed_at(second, "disarmed", "emergency_stop"));
  EXPECT_THAT(screen.lines(warm_ball()).back(), EndsWith("derating_ended"));
}

TEST(WatchEvents, AreThreeAndNewestFirstWhenNoneIsReserved) {
  WatchScreen screen({});
  for (std::int64_t second = 1; second < 9; ++second)
    take(screen, event_at(second, "device_attached"));
  const auto lines = screen.lines(warm_ball());
  EXPECT_EQ(lines.size(), 22U);
  EXPECT_EQ(lines.end()[-3], "  14:00:08  device_attached");
  EXPECT_EQ(lines.end()[-1], "  14:00:06  device_attached");
}

TEST(WatchScreen, ShowsTheHottestWindingFirst) {
  WatchScreen screen({});
  screen.take(hot_ball().status);
  const auto lines = screen.lines(hot_ball());
  EXPECT_LE(lines.size(), 22u);
  EXPECT_THAT(lines, testing::Contains(testing::AllOf(StartsWith("  temperature    66.1 °C  ━━━"),
                                                      EndsWith("thermistor 38.3 °C"))));
  EXPECT_THAT(lines, testing::Contains(testing::AllOf(StartsWith("  last minute  winding y  "),
                                                      EndsWith("66 to 66 °C"))));
}

TEST(WatchEvents, FillTheRowsOfTheTerminal) {
  for (const std::size_t rows : {22U, 24U, 40U}) {
    WatchScreen screen({});
    screen.set_size({80, rows});
    for (std::int64_t second = 1; second < 60; ++second)
      take(screen, event_at(second, "effect_started"));
    EXPECT_EQ(screen.lines(warm_ball()).size(), rows);
  }
}

TEST(WatchScreen, TheGaugesFillTheWidthOfTheTerminal) {
  const auto gauge = [](std::size_t columns, const std::string& name) {
    WatchScreen screen({.ascii = true});
    screen.set_size({columns, 22});
    for (const std::string& line : screen.lines(hot_ball())) {
      if (!line.starts_with(name)) continue;
      EXPECT_LE(line.size(), columns) << line;
      return static_cast<std::size_t>(std::count_if(line.begin() + 26, line.end(), [](char c) {
        return std::string_view("=-|").find(c) != std::string_view::npos;
      }));
    }
    ADD_FAILURE() << name;
    return std::size_t{0};
  };
  for (const char* name : {"  temperature ", "  current "}) {
    EXPECT_EQ(gauge(80, name), 26U) << name;
    EXPECT_EQ(gauge(120, name), 66U) << name;
    EXPECT_EQ(gauge(400, name), 100U) << name << ": more columns say nothing more";
  }
}

TEST(WatchScreen, ValuesBesideTheGaugesAreInOneColumn) {
  WatchScreen screen({});
  screen.set_size({130, 22});
  Ball ball = hot_ball();
  screen.take(ball.status);
  const auto lines = screen.lines(ball);
  const auto column = [&](const std::string& words) {
    for (const std::string& line : lines)
      if (const std::size_t at = line.find(words); at != std::string::npos)
        return columns(line.substr(0, at));
    return std::size_t{0};
  };
  EXPECT_EQ(column("thermistor 38.3"), 26U + 76U + 2U);
  EXPECT_EQ(column("66 to 66"), column("thermistor 38.3"));
  EXPECT_EQ(column("x 0.0  y +5.0"), column("thermistor 38.3"));
}

TEST(WatchScreen, FitsATerminalOf24Rows) {
  WatchScreen screen({});
  Ball ball = warm_ball();
  screen.take(ball.status);
  protocol::Event started;
  started.type = "effect_started";
  started.effect = 431;
  for (int i = 0; i < 9; ++i) screen.take(started, "14:03:21");
  const auto lines = screen.lines(ball);
  EXPECT_LE(lines.size(), 24u);
  for (const std::string& line : lines) EXPECT_LE(columns(line), 80u) << line;
  EXPECT_THAT(lines[0], HasSubstr("SPACE stops   q quits"));
  EXPECT_EQ(lines.back(), "  14:03:21  effect_started  #431");
}

}  // namespace
}  // namespace hedgehog::client

// SPDX-License-Identifier: MIT
// Output of `hedgehogctl preview`, `trips` and `events --since`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <time.h>

#include "base/wall_time.h"
#include "clients/ctl/arguments/since_argument.h"
#include "clients/ctl/screen/forecast_screen.h"
#include "clients/ctl/screen/history_screen.h"
#include "clients/ctl/screen/preview_screen.h"
#include "clients/ctl/screen/trips_screen.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(PreviewScreen, DrawsEachWindingToOneScaleAndReportsDerating) {
  protocol::PreviewResult preview{.duration_ms = 10'000, .step_ms = 50};
  for (int i = 0; i < 200; ++i) {
    preview.current_a.push_back({0.0, i < 100 ? 15.0 : 9.0, -4.0});
    preview.duty.push_back({0.0, 0.56, -0.15});
  }
  preview.peak_current_a = 15.52;
  preview.temperature_c = 55;
  preview.peak_temperature_c = 64.94;
  preview.limited_by = "thermal";
  preview.limited_from_ms = 5010;
  preview.delivered = {0.6, 0.8};
  const auto lines = preview_screen("pulse left", preview, true);
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[0], "pulse left, 10000 ms, if it were started now. Nothing was played.");
  EXPECT_EQ(lines[1], "  x  nothing flows");
  EXPECT_EQ(lines[2], "  y  9.0 to 15.0 A     " + std::string(25, '=') + std::string(25, '_'));
  EXPECT_EQ(lines[3], "  z  -4.0 A            " + std::string(50, '-')) << "a constant is a line";
  EXPECT_EQ(lines[4], "  current      15.5 A at most, duty 56 %");
  EXPECT_EQ(lines[5], "  temperature  55.0 °C now, 64.9 °C at most");
  EXPECT_EQ(lines[6], "  limited by   heat, from 5.01 s on: 80 % on average, at least 60 %");
  preview.limited_by.reset();
  EXPECT_THAT(preview_screen("pulse left", preview, false)[6], HasSubstr("nothing"));
  preview.current_a.clear();
  EXPECT_EQ(preview_screen("x", preview, false)[2], "  y  nothing flows");
}

TEST(ForecastScreen, ShowsKnownFiguresAndMarksUnknownOnes) {
  protocol::ForecastResult forecast{.seconds_to_derating = 22.0, .sustainable_a = 5.6};
  forecast.recovery_s = 0.0;
  EXPECT_THAT(forecast_screen(forecast, 15.0, "left"),
              ElementsAre("15.0 A from now, left:", "  derated     in 22 s",
                          "  trips       never, if nothing were reduced", "  for ever    5.6 A",
                          "  full again  now"));
  forecast.temperature_known = false;
  const auto unknown = forecast_screen(forecast, 15.0, "left");
  EXPECT_THAT(unknown[0], HasSubstr("temperature of the ball is unknown"));
  for (const std::string& line : unknown) {
    EXPECT_THAT(line, testing::Not(testing::AnyOf(HasSubstr("never"), HasSubstr("for ever"))));
    EXPECT_LE(columns(line), 90u);
  }
}

TEST(TripsScreen, IsNewestFirstAndLeavesRestartsOut) {
  ::setenv("TZ", "UTC0", 1);
  ::tzset();
  const auto trip = [](const char* at, const char* reason) {
    protocol::PastEvent event{.at = at, .event = {.type = "state_changed"}};
    event.event.state = "tripped";
    event.event.reason = reason;
    event.event.current_a = 10.6;
    return event;
  };
  protocol::HistoryResult history;
  history.events.push_back(trip("2026-10-09T18:02:51.000Z", "fan_stopped"));
  history.events[0].event.temperature_c = 61.0;
  history.events[0].client = "hedgehogctl";
  history.events[0].recording = "trip-0016";
  history.events.push_back(trip("2026-11-20T23:14:07.412Z", "thermometer_disagrees"));
  history.events.push_back(trip("2026-11-20T23:15:00.000Z", "fan_stopped"));
  history.events[2].event.current_a.reset();
  protocol::PastEvent armed{.at = "2026-11-21T00:00:00Z", .event = {.type = "state_changed"}};
  armed.event.state = "armed";
  history.events.push_back(armed);
  const auto lines = trips_screen(history);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0],
            "  WHEN                 REASON               COIL CURRENT  PLAYING      BLACK BOX");
  EXPECT_EQ(lines[1], "  2026-11-20 23:14:07  thermometer_disa…       -  10.6 A  -            -");
  EXPECT_EQ(lines[2],
            "  2026-10-09 18:02:51  fan_stopped       61.0 °C  10.6 A  hedgehogctl  trip-0016");
  for (const std::string& line : lines) EXPECT_LE(columns(line), 80u);
  EXPECT_THAT(trips_screen(history, {.cuts = false})[1], HasSubstr("  thermometer_disagrees  "));
  EXPECT_EQ(trips_screen({}).front(), "  no trips");
  history.more = true;
  EXPECT_EQ(trips_screen(history).size(), 4u);
  EXPECT_EQ(trips_screen(history).back(), "  older ones are not shown");
  EXPECT_EQ(trips_screen({{}, true}).front(), "  older ones are not shown")
      << "it may have tripped";
}

TEST(HistoryScreen, HasALineADayAndALineAnEvent) {
  ::setenv("TZ", "UTC0", 1);
  ::tzset();
  protocol::HistoryResult history;
  EXPECT_THAT(history_screen(history), ElementsAre("  no events"));
  history.events.push_back(
      {.at = "2026-11-20T23:14:07.412Z", .event = {.type = "state_changed", .state = "tripped"}});
  history.events.back().event.reason = "sensor_frozen";
  history.events.push_back(
      {.at = "2026-11-20T23:14:07.413Z", .event = {.type = "effect_ended", .effect = 431}});
  history.events.back().client = "Racer/1.2";
  history.events.push_back({.at = "2026-11-21T00:00:00Z", .event = {.type = "derating_ended"}});
  EXPECT_THAT(history_screen(history),
              ElementsAre("  2026-11-20", "  23:14:07.412  state_changed  tripped: sensor_frozen",
                          "  23:14:07.413  effect_ended  #431 (Racer/1.2)", "  2026-11-21",
                          "  00:00:00.000  derating_ended"));
}

TEST(HistoryScreen, ShowsTheCountAndLastTimeOfRecurringEvents) {
  ::setenv("TZ", "UTC0", 1);
  ::tzset();
  protocol::HistoryResult history;
  history.events.push_back(
      {.at = "2026-11-20T23:14:07.412Z", .event = {.type = "overrun", .skipped = 812}});
  history.events.back().count = 37;
  history.events.back().last = "2026-11-20T23:58:01.500Z";
  EXPECT_EQ(history_screen(history)[1],
            "  23:14:07.412  overrun  812 ticks skipped  37 times, the last at 23:58:01.500");
  history.events.back().last = "2026-11-21T00:03:01.500Z";
  EXPECT_THAT(history_screen(history)[1],
              testing::EndsWith("37 times, the last 2026-11-21 at 00:03:01.500"));
}

// Now is a Saturday, 02:30 local time, UTC+1.
TEST(SinceArgument, IsADayATimeASpanOrExact) {
  ::setenv("TZ", "CET-1", 1);
  ::tzset();
  const auto since = [](const std::string& text) {
    const auto now_ms = base::parse_rfc3339("2026-11-21T01:30:00Z");
    const auto time = since_rfc3339(text, *now_ms);
    return time ? *time : "none";
  };
  EXPECT_EQ(since("today"), "2026-11-20T23:00:00.000Z");
  EXPECT_EQ(since("yesterday"), "2026-11-19T23:00:00.000Z");
  EXPECT_EQ(since("90s"), "2026-11-21T01:28:30.000Z");
  EXPECT_EQ(since("30min"), "2026-11-21T01:00:00.000Z");
  EXPECT_EQ(since("2h"), "2026-11-20T23:30:00.000Z");
  EXPECT_EQ(since("3d"), "2026-11-18T01:30:00.000Z");
  EXPECT_EQ(since("02:14"), "2026-11-21T01:14:00.000Z");
  EXPECT_EQ(since("23:14"), "2026-11-20T22:14:00.000Z") << "the last time it was so";
  EXPECT_EQ(since("2026-11-20"), "2026-11-19T23:00:00.000Z");
  EXPECT_EQ(since("2026-11-20 23:14:07"), "2026-11-20T22:14:07.000Z");
  EXPECT_EQ(since("2026-11-20T23:14:07.412Z"), "2026-11-20T23:14:07.412Z");
  for (const char* bad : {"", "tomorrow", "2", "2 h", "-2h", "2fortnights", "25:00", "2026-13-01",
                          "99999999999999999999d", "40000d", "2026-02-31"})
    EXPECT_EQ(since(bad), "none") << bad;
}

}  // namespace
}  // namespace hedgehog::client

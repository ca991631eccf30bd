// SPDX-License-Identifier: MIT
// The tour: its frames, and the order of its effects.
#include "clients/ctl/demo/demo_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "clients/ctl/terminal/words.h"
#include "tests/clients/warm_ball.h"

namespace hedgehog::client {
namespace {

using testing::EndsWith;
using testing::StartsWith;

TEST(DemoScreen, ShowsTheHottestWindingFirstAndNamesTheThermistor) {
  const auto lines = demo_screen(hot_ball(), tour(true).front(), nullptr, {});
  const auto first = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("  temperature ");
  });
  ASSERT_GE(lines.end() - first, 4);
  EXPECT_THAT(first[0], StartsWith("  temperature    66.1 °C  ━━━"));
  EXPECT_THAT(first[0], EndsWith("derates at 60, trips at 70"));
  EXPECT_EQ(first[1], "               winding y  the hottest; x 40.8 °C, z 38.4 °C");
  EXPECT_EQ(first[2], "  thermistor     38.3 °C  on winding z, 3 ms old");
  EXPECT_THAT(first[3], StartsWith("  current "));
}

TEST(DemoScreen, FitsATerminalOf22Rows) {
  for (const TourChapter& chapter : tour(true)) {
    const TourStep* playing = chapter.steps.empty() ? nullptr : &chapter.steps.front();
    const auto lines = demo_screen(warm_ball(), chapter, playing, {});
    EXPECT_LE(lines.size(), 22u);
    for (const std::string& line : lines) EXPECT_LE(columns(line), 80u) << line;
  }
}

TEST(Tour, LastsAtMostFortySecondsAndNeverGoesBack) {
  const auto chapters = tour(true);
  EXPECT_LE(chapters.back().to, std::chrono::seconds(40));
  Milliseconds before{0};
  int numbered = 0;
  for (const TourChapter& chapter : chapters) {
    EXPECT_EQ(chapter.from, before);
    before = chapter.to;
    numbered += chapter.number > 0 ? 1 : 0;
    EXPECT_TRUE(std::is_sorted(chapter.steps.begin(), chapter.steps.end(),
                               [](const auto& a, const auto& b) { return a.at < b.at; }));
    for (const TourStep& step : chapter.steps) {
      EXPECT_GE(step.at, chapter.from);
      EXPECT_LT(step.at, chapter.to);
    }
  }
  EXPECT_EQ(numbered, kTourChapters);
}

TEST(Tour, TurnsOnlyASimulatedBall) {
  for (const TourChapter& chapter : tour(false))
    for (const TourStep& step : chapter.steps) EXPECT_NE(step.method, "sim.set");
}

}  // namespace
}  // namespace hedgehog::client

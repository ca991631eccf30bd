// SPDX-License-Identifier: MIT
// The exact output of `pins --live`.
#include "clients/ctl/screen/pins_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "clients/ctl/screen/ball_map.h"
#include "clients/ctl/terminal/words.h"
#include "model/geometry/pin_motion.h"
#include "tests/clients/thesis_description.h"

namespace hedgehog::client {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

Ball armed_ball() {
  Ball ball;
  ball.status.device = "ball-7";
  ball.status.state = "armed";
  ball.status.limit_a = 15;
  return ball;
}

// For any currents and either calibration: each number is separate and can be read back.
RC_GTEST_PROP(BallNumbers, AreSeparateInEightyColumns, ()) {
  const auto part = [] { return *rc::gen::inRange(-150, 151) / 10.0; };
  const model::Vec3 field{part(), part(), part()};
  const auto motion = model::pin_motion(model::thesis_ball().array, model::thesis_ball().curves,
                                        {field}, *rc::gen::element(0.0126, 0.02667));
  const auto lines = ball_numbers(model::thesis_ball().array, motion.extension_mm, motion.force_n,
                                  {.ascii = true});
  RC_ASSERT(lines.size() == 10u);
  std::multiset<std::string> expected;
  std::multiset<std::string> drawn;
  for (std::size_t row = 0; row < 8; ++row) {
    RC_ASSERT(columns(lines[row + 1]) <= 79u);
    std::istringstream text(lines[row + 1]);
    for (std::string word; text >> word;) drawn.insert(word);
    for (const model::Pin& pin : model::thesis_ball().array.ring(row)) {
      const std::string number =
          fixed(100.0 * motion.extension_mm[static_cast<std::size_t>(pin.id)], 0);
      expected.insert(number == "0" ? "." : number);
    }
    RC_ASSERT(drawn == expected);
  }
}

// For any input from a daemon: nothing is written outside the line.
RC_GTEST_PROP(BallNumbers, AnyPinsAndAnyNumbersStayInTheirLines, ()) {
  const auto part = [] { return *rc::gen::inRange(-100, 101) / 100.0; };
  protocol::Description description;
  for (int i = *rc::gen::inRange(0, 300); i > 0; --i)
    description.pins.push_back({i, {part(), part(), part()}, *rc::gen::inRange(-3, 400), 0.0});
  const std::vector<double> out(description.pins.size(),
                                *rc::gen::element(0.0, -9.994, 1e300, -1e300, 0.24));
  const model::PinArray pins = pin_array(description);
  const BallMapStyle style{.ascii = true, .world_up = model::Vec3{part(), part(), 1}};
  for (const std::string& line : ball_numbers(pins, out, out, style))
    RC_ASSERT(columns(line) <= 79u);
  RC_ASSERT(ball_map(pins, out, style).size() == 10u);
}

TEST(BallNumbers, MarkUpAndColourStrongForces) {
  std::vector<double> out(86);
  std::vector<double> forces(86);
  out[0] = 0.236;
  forces[0] = 0.19;
  out[80] = -0.094;
  const auto plain = ball_numbers(model::thesis_ball().array, out, forces,
                                  {.ascii = true, .world_up = model::Vec3{0, 0, 1}});
  EXPECT_THAT(plain[1], EndsWith(" ^24"));
  EXPECT_THAT(plain[8], HasSubstr(" -9 "));
  const auto coloured = ball_numbers(model::thesis_ball().array, out, forces, {.colour = true});
  EXPECT_THAT(coloured[1], EndsWith("\033[1m24\033[0m"));
  EXPECT_THAT(coloured[8], HasSubstr("\033[2m-9\033[0m"));
}

TEST(PinsScreen, ShowsTheFarthestPinIn80By22) {
  Ball ball = armed_ball();
  const auto motion = model::pin_motion(model::thesis_ball().array, model::thesis_ball().curves,
                                        {{0, 0, 15}}, 0.0126);
  ball.status.pins = {motion.force_n, motion.extension_mm};
  ball.status.remedy = "Run: hedgehogctl arm";
  ball.description = thesis_description();
  for (std::size_t pin = 1; pin < 8; ++pin)
    ball.description.pins[pin].rest_mm = pin == 7 ? 0.56 : 0.5;
  const auto lines = pins_screen(ball, {});
  EXPECT_LE(lines.size(), 22u);
  for (const std::string& line : lines) EXPECT_LE(columns(line), 80u) << line;
  EXPECT_THAT(lines[0], HasSubstr("SPACE stops   q quits"));
  EXPECT_THAT(lines[11], HasSubstr("hundredths of a millimetre"));
  EXPECT_THAT(
      lines[11],
      EndsWith(" out, " +
               std::to_string(std::count_if(motion.extension_mm.begin(), motion.extension_mm.end(),
                                            [](double mm) { return mm <= -0.005; })) +
               " in"));
  EXPECT_THAT(lines[12], HasSubstr("hedgehogctl arm"));
  const std::size_t farthest = static_cast<std::size_t>(
      std::max_element(motion.extension_mm.begin(), motion.extension_mm.end()) -
      motion.extension_mm.begin());
  EXPECT_THAT(lines[13], StartsWith("  pin " + right(std::to_string(farthest), 2)));
  EXPECT_THAT(lines[13],
              EndsWith("rests " + fixed(ball.description.pins[farthest].rest_mm, 2) + " mm out"));
  EXPECT_THAT(pins_line(ball.status), EndsWith(" in"));
}

TEST(PinsScreen, ReportsThatAllPinsRest) {
  const Ball ball = armed_ball();
  EXPECT_THAT(pins_screen(ball, {}), testing::Contains("  all pins rest"));
  EXPECT_THAT(pins_line(ball.status), EndsWith("all pins rest"));
  EXPECT_EQ(aimed_pin_words(ball.status), "no force");
}

}  // namespace
}  // namespace hedgehog::client

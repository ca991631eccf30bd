// SPDX-License-Identifier: MIT
// Debian's Chromium, unmodified, on the gamepad: a page that uses the Gamepad API.
#include <string>

#include "tests/folders.h"
#include "tests/vm/gamepad_bench.h"

namespace hedgehog::vm {
namespace {

using testing::HasSubstr;

// From hello.limits.
constexpr double kFeltA = 2.1;
constexpr int kMaxTilts = 60;
constexpr double kHeldMs = 1000;

class GamepadBrowser : public GamepadBench {
 protected:
  void SetUp() override { begin({"--trace"}); }
  /// Reads from the ball until the page has printed the text.
  bool prints(const std::string& text) {
    for (int minute = 0; minute < kManyMinutes; ++minute)
      if (ball_->until([&] { return has_printed(text) || browser_->ended(); })) break;
    return has_printed(text);
  }
  /// Tilts the ball to the right and back, a second each, until the page has printed the text.
  bool prints_when_tilted(const std::string& text) {
    for (int turns = 0; turns < 2 * kMaxTilts && !browser_->ended(); ++turns) {
      turn(model::axis_angle(kFront, turns % 2 == 0 ? 60 : 0));
      const double from = now_ms();
      ball_->until([&] { return has_printed(text) || now_ms() - from > kHeldMs; });
      if (has_printed(text)) return true;
    }
    return false;
  }
  bool has_printed(const std::string& text) const {
    return printed().find(text) != std::string::npos;
  }
  std::string printed() const { return home_.read("browser"); }

  std::optional<Child> browser_;
};

// A page sees no gamepad before a button is pressed or an axis is moved by more than half; the ball
// has no buttons. Chromium keeps an axis at 0 until it has found it at rest once, and begins to
// look some time after the page has asked for gamepads, of which nothing tells the test. It
// therefore does what a person does whose tilt has no effect: level the ball and tilt it again.
TEST_F(GamepadBrowser, ChromiumReadsTheTiltAndPlaysDualRumble) {
  shell("udevadm settle");
  browser_.emplace(
      std::vector<std::string>{"/usr/bin/chromium-headless-shell", "--no-sandbox", "--no-zygote",
                               "--single-process", "--disable-gpu", "--enable-logging=stderr",
                               "--user-data-dir=" + home_.path("profile"),
                               "file://" + source_folder() + "/tests/vm/gamepad_page.html"},
      debian_environment(), home_.path("browser"));
  ASSERT_TRUE(prints("page ready")) << printed();
  ASSERT_TRUE(prints_when_tilted("gamepad " + std::string(kGamepadName))) << printed();
  EXPECT_THAT(printed(), HasSubstr("(Vendor: 1209 Product: 0002), 2 axes, "));
  EXPECT_TRUE(prints("dual-rumble: complete")) << printed();
  EXPECT_TRUE(ball_->until_ended(1)) << ball_->text() << bridge_log();
  print("chromium");
  ASSERT_EQ(ball_->played().size(), 1U) << ball_->text();
  const PlayedEffect& rumble = ball_->played().front();
  EXPECT_EQ(rumble.method, "effect.vibrate");
  EXPECT_GT(dot(rumble.side, kDown), 0.99) << "two motors have no direction";
  EXPECT_GT(rumble.peak_a, kFeltA);
  EXPECT_GT(rumble.flowed_ms, 0);
}

}  // namespace
}  // namespace hedgehog::vm

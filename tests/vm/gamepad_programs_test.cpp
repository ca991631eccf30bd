// SPDX-License-Identifier: MIT
// Debian programs without support for the ball, unmodified, on the gamepad.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/folders.h"
#include "tests/vm/gamepad_bench.h"

namespace hedgehog::vm {
namespace {

using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;

const std::string kSdlTests = "/usr/libexec/installed-tests/SDL2/";

/// A program with input from the test; both of its outputs go to the file `log`.
class Typed {
 public:
  Typed(const std::string& command, const std::string& log)
      : pipe_(::popen((command + " >>" + log + " 2>&1").c_str(), "w")) {}
  Typed(const Typed&) = delete;
  Typed& operator=(const Typed&) = delete;
  ~Typed() { end(); }

  void type(const std::string& line) const {
    std::fputs((line + "\n").c_str(), pipe_);
    std::fflush(pipe_);
  }
  /// Its exit status as returned by pclose.
  int end() {
    const int status = pipe_ == nullptr ? 0 : ::pclose(pipe_);
    pipe_ = nullptr;
    return status;
  }

 private:
  std::FILE* pipe_;
};

class GamepadPrograms : public GamepadBench {
 protected:
  void SetUp() override { begin({"--trace"}); }
  void start(const std::vector<std::string>& words) {
    std::vector<std::string> environment = debian_environment();
    environment.emplace_back("SDL_VIDEODRIVER=dummy");
    shell("udevadm settle");
    program_.emplace(words, environment, home_.path("program"));
  }
  /// Waits until it has ended.
  void wait() {
    EXPECT_TRUE(ball_->until([&] { return program_->ended(); })) << printed();
  }
  std::string printed() const { return home_.read("program"); }
  /// How often the program has started an effect at the event node.
  std::size_t plays() const {
    const std::vector<std::string> all = game_commands();
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [](const auto& one) { return one.starts_with("play "); }));
  }
  /// The effects of the ball in the order of their starts.
  const PlayedEffect& effect(std::size_t number) const { return ball_->played().at(number); }

  std::optional<Child> program_;
};

// Rows of fftest's list: 0 a sine along x, 1 a constant force from behind to the right, 4 the
// strong motor, 5 the weak one. Springs and dampers, 2 and 3, are rejected.
TEST_F(GamepadPrograms, Fftest) {
  const model::Vec3 back_right{-0.7071, -0.7071, 0};
  const auto play = [&](const std::string& number, const model::Vec3& side) {
    Typed fftest("fftest " + node(), home_.path("program"));
    fftest.type(number);
    EXPECT_TRUE(ball_->until_pushed(side, 2)) << printed() << ball_->text() << bridge_log();
    fftest.type("-1");
    EXPECT_EQ(fftest.end(), 0) << printed();
    EXPECT_TRUE(ball_->until_still());
  };
  play("0", kDown);
  play("1", back_right);
  play("4", kDown);
  play("5", kDown);
  EXPECT_THAT(printed(), HasSubstr("Constant, Periodic, Ramp, Rumble, Gain"));
  EXPECT_THAT(printed(), HasSubstr("Uploading effect #0 (Periodic sinusoidal) ... OK"));
  EXPECT_THAT(printed(), HasSubstr("Uploading effect #2 (Spring) ... Error: Invalid argument"));
  ASSERT_EQ(ball_->played().size(), 4U) << ball_->text();
  for (const PlayedEffect& one : ball_->played()) EXPECT_EQ(one.ended, "stopped") << ball_->text();
  print("fftest");
  EXPECT_THAT(game_commands(), Contains(HasSubstr(": sine from 0x4000, ")));
  EXPECT_THAT(game_commands(), Contains(ContainsRegex(": constant [0-9]+ from 0x6000, attack ")));
}

// The effects of SDL's list that the ball can play, five seconds each, forces by the compass
// direction from which they come. The program omits springs, dampers, friction and inertia, because
// the gamepad does not offer them.
TEST_F(GamepadPrograms, SdlTesthaptic) {
  const auto azimuth = [](double from_deg) {
    const double rad = -from_deg * 3.14159265 / 180.0;
    return model::Vec3{std::cos(rad), std::sin(rad), 0};
  };
  start({kSdlTests + "testhaptic"});
  wait();
  print("testhaptic");
  struct Expected {
    std::string text;
    std::string method;
    model::Vec3 side;
  };
  const std::vector<Expected> all{{"Sine Wave", "effect.play", kFront},
                                  {"Sawtooth Up", "effect.play", kFront},
                                  {"Constant Force", "effect.play", azimuth(200)},
                                  {"Ramp", "effect.play", azimuth(225 - 180)},
                                  {"Left/Right", "effect.vibrate", kDown}};
  ASSERT_EQ(ball_->played().size(), all.size()) << printed();
  EXPECT_EQ(plays(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PlayedEffect& one = effect(i);
    EXPECT_THAT(printed(), HasSubstr("effect " + std::to_string(i) + ": " + all[i].text));
    EXPECT_EQ(one.method, all[i].method) << i;
    // The ramp goes from a negative force to an equal positive one: its peak may be on either side.
    const bool is_ramp = all[i].text == "Ramp";
    EXPECT_GT(dot(is_ramp ? one.begun_at : one.side, all[i].side), 0.99) << i;
    EXPECT_EQ(one.ended, "completed") << i;
    EXPECT_NEAR(one.flowed_ms, 5000, 1) << i;
  }
}

TEST_F(GamepadPrograms, SdlTestrumble) {
  start({kSdlTests + "testrumble"});
  wait();
  print("testrumble");
  ASSERT_GE(ball_->played().size(), 2U) << printed();
  EXPECT_GE(plays(), ball_->played().size());
  for (const PlayedEffect& one : ball_->played()) {
    EXPECT_EQ(one.method, "effect.vibrate");
    EXPECT_GT(dot(one.side, kDown), 0.99) << "SDL's rumble has no direction";
  }
}

TEST_F(GamepadPrograms, Pygame) {
  start({"/usr/bin/python3", source_folder() + "/tests/vm/pygame_pad.py"});
  EXPECT_TRUE(ball_->until_pushed(kDown, 8)) << printed();
  EXPECT_TRUE(ball_->until_ended(1)) << printed();
  turn(model::axis_angle(kFront, 60));
  wait();
  EXPECT_THAT(printed(),
              HasSubstr(std::string(kGamepadName) + " axes 2 buttons 11\nrumble True\n"));
  EXPECT_THAT(printed(), HasSubstr("tilted, rumble True"));
  print("python3-pygame");
  EXPECT_GE(plays(), 2U);
}

}  // namespace
}  // namespace hedgehog::vm

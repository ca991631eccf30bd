// SPDX-License-Identifier: MIT
// The options of hedgehog-gamepad, as a user gives them: each changes what a game reads or what the
// ball does.
#include "tests/vm/gamepad_bench.h"

namespace hedgehog::vm {
namespace {

class GamepadOptions : public GamepadBench {
 protected:
  /// Plays it until the ball pushes that side.
  bool pushes(ff_effect effect, const model::Vec3& side) {
    const EventNode game(node());
    EXPECT_EQ(game.upload(effect), 0);
    game.play(effect.id);
    const bool pushed = ball_->until_pushed(side, 5);
    EXPECT_EQ(game.erase(effect.id), 0);
    EXPECT_TRUE(ball_->until_still());
    return pushed;
  }
};

TEST_F(GamepadOptions, ChooseWhereTheStickEndsBeginsAndHowItRises) {
  begin({"--full-deg", "90", "--dead-zone-deg", "9", "--curve", "1"});
  const EventNode game(node());
  turn(model::axis_angle(kFront, 60));
  // (60 - 9) of (90 - 9) degrees.
  EXPECT_TRUE(stick_reaches(game, 20'400, 0));
  EXPECT_LT(game.axis(ABS_X).value, 20'900);
  turn(model::axis_angle(kFront, 8));
  EXPECT_TRUE(stick_reaches(game, 0, 0)) << "within the dead zone";
}

TEST_F(GamepadOptions, ChooseWhereAnEffectWithoutADirectionPushes) {
  begin({"--rumble-direction", "back"});
  EXPECT_TRUE(pushes(rumble(), kBack));
  EXPECT_TRUE(pushes(wave(FF_SINE, 0x4000), kBack)) << "SDL's rumble has none";
  EXPECT_TRUE(pushes(wave(FF_SINE, 0xc000), kLeft)) << "others keep theirs";
}

TEST_F(GamepadOptions, GiveAWaveFromTheRightItsSideAndAllEffectsLess) {
  begin({"--sdl-rumble", "no", "--full-level", "0.5"});
  EXPECT_TRUE(pushes(wave(FF_SINE, 0x4000), kRight));
  EXPECT_TRUE(pushes(rumble(), kDown));
  const EventNode game(node());
  ff_effect effect = constant(0x0000, kFull);
  ASSERT_EQ(game.upload(effect), 0);
  game.play(effect.id);
  EXPECT_TRUE(ball_->until_pushed(kFront, 7));
  EXPECT_LT(ball_->current_a(), 8) << "half of 15 A";
}

}  // namespace
}  // namespace hedgehog::vm

// SPDX-License-Identifier: MIT
// hedgehog-gamepad on the kernel's uinput: the event node as a game uses it, and the ball's
// effects.
#include <array>
#include <cerrno>
#include <string>

#include "tests/vm/gamepad_bench.h"

namespace hedgehog::vm {
namespace {

class GamepadNode : public GamepadBench {
 protected:
  void SetUp() override {
    begin();
    if (HasFatalFailure()) return;
    game_.emplace(node());
  }
  bool stick_reaches(int x, int y) const { return vm::stick_reaches(*game_, x, y); }

  std::optional<EventNode> game_;
};

TEST_F(GamepadNode, HasTheCapabilitiesThatGamesExpect) {
  for (const int type : {EV_KEY, EV_ABS, EV_FF}) EXPECT_TRUE(game_->has(0, type)) << type;
  EXPECT_TRUE(game_->has(EV_KEY, BTN_GAMEPAD));
  for (const int one : {FF_RUMBLE, FF_CONSTANT, FF_PERIODIC, FF_RAMP, FF_GAIN, FF_SQUARE,
                        FF_TRIANGLE, FF_SINE, FF_SAW_UP, FF_SAW_DOWN})
    EXPECT_TRUE(game_->has(EV_FF, one)) << one;
  for (const int one : {FF_SPRING, FF_DAMPER, FF_FRICTION, FF_INERTIA, FF_CUSTOM, FF_AUTOCENTER})
    EXPECT_FALSE(game_->has(EV_FF, one)) << one;
  for (const int one : {ABS_X, ABS_Y}) {
    EXPECT_TRUE(game_->has(EV_ABS, one));
    EXPECT_EQ(game_->axis(one).minimum, -kFull);
    EXPECT_EQ(game_->axis(one).maximum, kFull);
  }
  EXPECT_FALSE(game_->has(EV_ABS, ABS_Z));
  shell("udevadm settle");
  const std::string properties = shell("udevadm info " + node());
  EXPECT_THAT(properties, testing::HasSubstr("ID_INPUT_JOYSTICK=1"));
  EXPECT_THAT(properties, testing::ContainsRegex("TAGS=.*:uaccess:")) << "who sits here may play";
  EXPECT_EQ(shell("ls /dev/input | grep -c '^js'"), "1\n") << "for games that know joydev only";
}

TEST_F(GamepadNode, TheStickFollowsTheBall) {
  constexpr int kFar = 30'000;
  turn(model::axis_angle(kFront, 60));
  EXPECT_TRUE(stick_reaches(kFar, 0)) << "tilted to the right";
  turn(model::axis_angle(kFront, -60));
  EXPECT_TRUE(stick_reaches(-kFar, 0)) << "tilted to the left";
  turn(model::axis_angle(kLeft, 60));
  EXPECT_TRUE(stick_reaches(0, -kFar)) << "tilted to the front: the stick is pushed";
  turn(model::axis_angle(kLeft, -60));
  EXPECT_TRUE(stick_reaches(0, kFar)) << "tilted to the back";
  turn({});
  EXPECT_TRUE(stick_reaches(0, 0));
}

TEST_F(GamepadNode, ASignalTakesThePresentTiltAsTheCentre) {
  turn(model::axis_angle(kFront, 60));
  ASSERT_TRUE(stick_reaches(30'000, 0));
  ::kill(bridge_->pid(), SIGUSR1);
  EXPECT_TRUE(stick_reaches(0, 0));
  turn({});
  EXPECT_TRUE(stick_reaches(-30'000, 0)) << "upright is to the left of it";
}

TEST_F(GamepadNode, AForcePushesTheSideItComesFromAndAnUpdateMovesIt) {
  ff_effect effect = constant(0x0000, kFull);
  ASSERT_EQ(game_->upload(effect), 0);
  game_->play(effect.id);
  EXPECT_TRUE(ball_->until_pushed(kFront, 10));
  for (const auto& [direction, side] :
       {std::pair{0x4000, kRight}, std::pair{0x8000, kBack}, std::pair{0xc000, kLeft}}) {
    effect.direction = static_cast<std::uint16_t>(direction);
    ASSERT_EQ(game_->upload(effect), 0) << "an update of what plays";
    EXPECT_TRUE(ball_->until_pushed(side, 10)) << direction;
  }
  effect.u.constant.level = -kFull;
  ASSERT_EQ(game_->upload(effect), 0);
  EXPECT_TRUE(ball_->until_pushed(kRight, 10)) << "a negative force pushes the opposite side";
  game_->play(effect.id, 0);
  EXPECT_TRUE(ball_->until_still());
  EXPECT_EQ(ball_->played().back().ended, "stopped");
  print("forces from four sides, updated while they play");
}

TEST_F(GamepadNode, TheGainReducesPlayingEffects) {
  ff_effect effect = constant(0x4000, kFull);
  ASSERT_EQ(game_->upload(effect), 0);
  game_->play(effect.id);
  ASSERT_TRUE(ball_->until_pushed(kRight, 10));
  const double full_a = ball_->current_a();
  game_->set_gain(0x8000);
  EXPECT_TRUE(ball_->until([&] { return ball_->current_a() < 0.6 * full_a; }));
  EXPECT_GT(ball_->current_a(), 0.3 * full_a);
  game_->set_gain(0xffff);
  EXPECT_TRUE(ball_->until_pushed(kRight, 0.9 * full_a));
}

TEST_F(GamepadNode, AnEffectOfAGivenLengthEndsByItselfAsOftenAsItIsToPlay) {
  ff_effect effect = constant(0xc000, kFull, 200);
  ASSERT_EQ(game_->upload(effect), 0);
  game_->play(effect.id, 3);
  EXPECT_TRUE(ball_->until_ended(3)) << ball_->text();
  for (const PlayedEffect& one : ball_->played()) EXPECT_GT(dot(one.side, kLeft), 0.99);
  EXPECT_EQ(ball_->played().back().ended, "completed");
  EXPECT_NEAR(ball_->played().back().flowed_ms, 200, 1);
}

TEST_F(GamepadNode, ErasingEndsAnEffectAndFreesItsPlace) {
  std::array<ff_effect, 16> all{};
  for (ff_effect& effect : all) {
    effect = constant(0x8000, kFull);
    ASSERT_EQ(game_->upload(effect), 0);
  }
  ff_effect more = constant(0x0000, kFull);
  EXPECT_EQ(game_->upload(more), ENOSPC);
  game_->play(all[7].id);
  ASSERT_TRUE(ball_->until_pushed(kBack, 10));
  EXPECT_EQ(game_->erase(all[7].id), 0);
  EXPECT_TRUE(ball_->until_still());
  EXPECT_EQ(ball_->played().back().ended, "stopped");
  more.id = -1;
  EXPECT_EQ(game_->upload(more), 0);
}

TEST_F(GamepadNode, ClosingTheHandleEndsTheEffectsOfThatGame) {
  EventNode other(node());
  ff_effect other_effect = constant(0x0000, kFull);
  ASSERT_EQ(other.upload(other_effect), 0);
  other.play(other_effect.id);
  ASSERT_TRUE(ball_->until_pushed(kFront, 10));
  ff_effect own_effect = constant(0x4000, kFull);
  ASSERT_EQ(game_->upload(own_effect), 0);
  game_->play(own_effect.id);
  ASSERT_TRUE(ball_->until([&] { return dot(ball_->side(), kRight) > 0.5; })) << "the two add";
  game_->close();
  EXPECT_TRUE(ball_->until_pushed(kFront, 10)) << "what the other game has goes on";
  other.close();
  EXPECT_TRUE(ball_->until_still());
  EXPECT_EQ(ball_->ended(), 2U);
  for (const PlayedEffect& one : ball_->played()) EXPECT_EQ(one.ended, "stopped");
  print("two games that close their handles");
}

TEST_F(GamepadNode, EveryWaveformAndRampsAndRumblePlay) {
  for (const int waveform : {FF_SQUARE, FF_TRIANGLE, FF_SINE, FF_SAW_UP, FF_SAW_DOWN}) {
    ff_effect effect = wave(waveform, 0x8000);
    ASSERT_EQ(game_->upload(effect), 0) << waveform;
    game_->play(effect.id);
    EXPECT_TRUE(ball_->until_pushed(kBack, 5)) << waveform;
    EXPECT_EQ(game_->erase(effect.id), 0);
    EXPECT_TRUE(ball_->until_still());
  }
  ff_effect motor = rumble();
  ASSERT_EQ(game_->upload(motor), 0);
  game_->play(motor.id);
  EXPECT_TRUE(ball_->until_pushed(kDown, 5));
  EXPECT_EQ(game_->erase(motor.id), 0);

  ff_effect ramp{};
  ramp.type = FF_RAMP;
  ramp.id = -1;
  ramp.direction = 0x4000;
  ramp.replay.length = 600;
  ramp.u.ramp.start_level = -kFull;
  ramp.u.ramp.end_level = kFull;
  ASSERT_EQ(game_->upload(ramp), 0);
  game_->play(ramp.id);
  EXPECT_TRUE(ball_->until_pushed(kLeft, 5)) << "it begins negative";
  EXPECT_TRUE(ball_->until_pushed(kRight, 5)) << "and ends positive";
  EXPECT_TRUE(ball_->until_ended(7)) << ball_->text();
  print("waves, a rumble and a ramp");
}

TEST_F(GamepadNode, ASpringIsRefused) {
  ff_effect spring{};
  spring.type = FF_SPRING;
  spring.id = -1;
  EXPECT_EQ(game_->upload(spring), EINVAL);
}

TEST_F(GamepadNode, DisappearsWithItsProgramAndTheBallIsStill) {
  ff_effect effect = constant(0x4000, kFull);
  ASSERT_EQ(game_->upload(effect), 0);
  game_->play(effect.id);
  ASSERT_TRUE(ball_->until_pushed(kRight, 10));
  EXPECT_EQ(bridge_->stop(SIGTERM), 130);
  EXPECT_TRUE(ball_->until_still());
  EXPECT_EQ(ball_->played().back().ended, "disconnected");
  EXPECT_EQ(game_->upload(effect), ENODEV);
  EXPECT_EQ(node(), "");
}

TEST_F(GamepadNode, StaysWithoutADaemonAndPlaysOnTheNextOne) {
  ff_effect effect = constant(0x4000, kFull);
  ASSERT_EQ(game_->upload(effect), 0);
  ball_.reset();
  EXPECT_EQ(daemon_->stop(SIGKILL), -1);
  EXPECT_TRUE(bridge_logs("reconnecting")) << bridge_log();
  EXPECT_EQ(game_->upload(effect), 0) << "a game is answered all the same";
  home_.write("bridge", "");
  daemon_.emplace(home_);
  daemon_->arm();
  ball_.emplace(home_.path("run/hedgehog/hedgehogd.sock"));
  ASSERT_TRUE(bridge_logs("connected to")) << bridge_log();
  game_->play(effect.id);
  EXPECT_TRUE(ball_->until_pushed(kRight, 10));
}

}  // namespace
}  // namespace hedgehog::vm

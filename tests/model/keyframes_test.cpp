// SPDX-License-Identifier: MIT
// Key frames as specified in protocol/README.md.
#include "model/effect/keyframes.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>

#include "model/effect/effect.h"

namespace hedgehog::model {
namespace {

Keyframe frame(int t_ms, double level, Vec3 direction = {1, 0, 0}, Ease ease = Ease::kLinear) {
  return {static_cast<float>(direction.x),  static_cast<float>(direction.y),
          static_cast<float>(direction.z),  static_cast<float>(level),
          static_cast<std::uint16_t>(t_ms), ease};
}

double level_at(const std::vector<Keyframe>& frames, double at_ms) {
  return point_at(frames, at_ms).level;
}

const Vec3 kFront{1, 0, 0};
const Vec3 kLeft{0, 1, 0};
const Vec3 kUp{0, 0, 1};

TEST(Keyframes, LevelsAreInterpolatedLinearly) {
  const std::vector<Keyframe> frames{frame(0, 0), frame(40, 0.5), frame(120, 0)};
  EXPECT_DOUBLE_EQ(level_at(frames, 0), 0.0);
  EXPECT_DOUBLE_EQ(level_at(frames, 20), 0.25);
  EXPECT_DOUBLE_EQ(level_at(frames, 40), 0.5);
  EXPECT_DOUBLE_EQ(level_at(frames, 80), 0.25);
  EXPECT_NEAR(level_at(frames, 119.5), 0.5 / 160, 1e-12);
}

TEST(Keyframes, AStepHoldsUntilTheNextOne) {
  const std::vector<Keyframe> frames{frame(0, 1, kFront, Ease::kStep), frame(60, 0, kLeft)};
  EXPECT_DOUBLE_EQ(level_at(frames, 59.9), 1.0);
  EXPECT_EQ(point_at(frames, 59.9).direction, kFront);
  EXPECT_DOUBLE_EQ(level_at(frames, 60), 0.0);
}

TEST(Keyframes, ASmoothOneIsSlowAtBothEnds) {
  const std::vector<Keyframe> frames{frame(0, 0, kFront, Ease::kSmooth), frame(100, 1)};
  EXPECT_NEAR(level_at(frames, 25), 0.15625, 1e-12);
  EXPECT_NEAR(level_at(frames, 50), 0.5, 1e-12);
  EXPECT_NEAR(level_at(frames, 75), 0.84375, 1e-12);
}

TEST(Keyframes, ItRestsBeforeTheFirstAndAfterTheLast) {
  const std::vector<Keyframe> frames{frame(10, 0.5), frame(20, 0.5)};
  EXPECT_DOUBLE_EQ(level_at(frames, 9.9), 0.0);
  EXPECT_DOUBLE_EQ(level_at(frames, 10), 0.5);
  EXPECT_DOUBLE_EQ(level_at(frames, 20), 0.5);
  EXPECT_DOUBLE_EQ(level_at(frames, 20.1), 0.0);
  EXPECT_DOUBLE_EQ(level_at({}, 5), 0.0);
}

TEST(Keyframes, OfSeveralAtOneTimeTheLastCounts) {
  const std::vector<Keyframe> frames{frame(0, 0), frame(50, 0.2), frame(50, 0.9), frame(100, 0.9)};
  EXPECT_NEAR(level_at(frames, 49.999), 0.2, 1e-5);
  EXPECT_NEAR(level_at(frames, 50), 0.9, 1e-6);
}

TEST(Keyframes, DirectionsFollowTheGreatCircle) {
  const std::vector<Keyframe> frames{frame(0, 1, kFront), frame(90, 1, kLeft)};
  for (int at = 0; at <= 90; ++at) {
    const Vec3 d = point_at(frames, at).direction;
    EXPECT_NEAR(std::atan2(d.y, d.x) * 180 / 3.14159265358979, at, 1e-6) << at;
    EXPECT_NEAR(norm(d), 1.0, 1e-9);
    EXPECT_NEAR(d.z, 0.0, 1e-12);
  }
}

TEST(Keyframes, OppositeDirectionsPassOverTheTopAndUpToDownOverTheFront) {
  EXPECT_NEAR(
      dot(point_at(std::vector{frame(0, 1, kFront), frame(2, 1, -kFront)}, 1).direction, kUp), 1.0,
      1e-9);
  EXPECT_NEAR(dot(point_at(std::vector{frame(0, 1, kUp), frame(2, 1, -kUp)}, 1).direction, kFront),
              1.0, 1e-9);
}

TEST(Keyframes, TheTurnRotatesFrontByTheShortestWay) {
  EXPECT_NEAR(norm(rotate(turn_from_front(kLeft), kFront) - kLeft), 0, 1e-12);
  EXPECT_NEAR(norm(rotate(turn_from_front(kLeft), kUp) - kUp), 0, 1e-12);
  EXPECT_NEAR(norm(rotate(turn_from_front(kUp), kLeft) - kLeft), 0, 1e-12);
  EXPECT_NEAR(norm(rotate(turn_from_front(-kFront), kFront) + kFront), 0, 1e-12);
  EXPECT_NEAR(norm(rotate(turn_from_front(-kFront), kUp) - kUp), 0, 1e-12) << "about up";
}

RC_GTEST_PROP(KeyframeLaws, TurnsToAnyDirection, ()) {
  const Vec3 towards =
      unit_or({*rc::gen::inRange(-100, 100) / 7.0, *rc::gen::inRange(-100, 100) / 9.0,
               *rc::gen::inRange(-100, 100) / 11.0},
              kLeft);
  const Quaternion q = turn_from_front(towards);
  RC_ASSERT(std::abs(norm(q) - 1.0) < 1e-9);
  RC_ASSERT(norm(rotate(q, kFront) - towards) < 1e-6);
}

RC_GTEST_PROP(KeyframeLaws, AnyPointIsAUnitVectorAndALevel, ()) {
  std::vector<Keyframe> frames;
  int t = 0;
  const int count = *rc::gen::inRange(1, 20);
  for (int i = 0; i < count; ++i) {
    t += *rc::gen::inRange(0, 50);
    frames.push_back(
        frame(t, *rc::gen::inRange(0, 101) / 100.0,
              unit_or({*rc::gen::inRange(-9, 10) * 1.0, *rc::gen::inRange(-9, 10) * 1.0,
                       *rc::gen::inRange(-9, 10) * 1.0},
                      kFront),
              static_cast<Ease>(*rc::gen::inRange(0, 3))));
  }
  const KeyframePoint point = point_at(frames, *rc::gen::inRange(0, 2000) / 2.0);
  RC_ASSERT(std::abs(norm(point.direction) - 1.0) < 1e-5);
  RC_ASSERT(point.level >= 0.0);
  RC_ASSERT(point.level <= 1.0);
}

EffectSpec play(double rate, bool loop) {
  EffectSpec spec;
  spec.method = EffectMethod::kPlay;
  spec.trajectory.path = Path::kKeyframes;
  spec.trajectory.playback = {.count = 2, .length_ms = 100, .loop = loop, .rate = rate, .turn = {}};
  return spec;
}

TEST(Keyframes, TheRateIsMillisecondsATick) {
  EffectPhase phase;
  for (int i = 0; i < 40; ++i) phase = advanced(play(1.5, false), phase);
  EXPECT_NEAR(phase.steps, 60, 1e-9);
}

TEST(Keyframes, ALoopBeginsAgainWhereItEnds) {
  EffectPhase phase;
  for (int i = 0; i < 1000; ++i) phase = advanced(play(0.1, true), phase);
  EXPECT_NEAR(phase.steps, 0, 1e-6) << "a thousand tenths are a whole turn";
  for (int i = 0; i < 25; ++i) phase = advanced(play(10, true), phase);
  EXPECT_NEAR(phase.steps, 50, 1e-6);
}

TEST(Keyframes, TheEndIsTheLengthDividedByTheRate) {
  EXPECT_EQ(ticks_to_end(play(1, false).trajectory.playback, 0), 100);
  EXPECT_EQ(ticks_to_end(play(2, false).trajectory.playback, 50), 25);
  EXPECT_EQ(ticks_to_end(play(3, false).trajectory.playback, 0), 34);
  EXPECT_EQ(ticks_to_end(play(1, false).trajectory.playback, 150), 0);
}

}  // namespace
}  // namespace hedgehog::model

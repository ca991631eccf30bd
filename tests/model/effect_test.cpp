// SPDX-License-Identifier: MIT
// Output of one effect over time: shapes, and `effect.circle`.
#include "model/effect/effect.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <vector>

namespace hedgehog::model {
namespace {

EffectSpec vibration(Waveform waveform, double frequency_hz, double on_fraction = 0.5) {
  EffectSpec spec;
  spec.method = EffectMethod::kVibrate;
  spec.waveform = waveform;
  spec.frequency_hz = frequency_hz;
  spec.on_fraction = on_fraction;
  spec.duration = 10'000;
  return spec;
}

EffectSpec circle(double ring_deg = 90, double speed = 10, bool smooth = false) {
  EffectSpec spec;
  spec.method = EffectMethod::kCircle;
  spec.trajectory.path = Path::kCircle;
  spec.trajectory.ring_deg = ring_deg;
  spec.trajectory.speed_pins_s = speed;
  spec.trajectory.smooth = smooth;
  spec.duration = 10'000;
  return spec;
}

std::vector<double> levels(const EffectSpec& spec, int ticks) {
  std::vector<double> out;
  EffectPhase phase;
  for (int i = 0; i < ticks; ++i, phase = advanced(spec, phase))
    out.push_back(level_at(spec, phase));
  return out;
}

std::vector<Vec3> directions(const EffectSpec& spec, int ticks) {
  std::vector<Vec3> out;
  EffectPhase phase;
  for (int i = 0; i < ticks; ++i, phase = advanced(spec, phase))
    out.push_back(direction_at(spec.trajectory, phase));
  return out;
}

double azimuth_deg(const Vec3& v) { return std::atan2(v.y, v.x) * 180.0 / 3.14159265358979; }
double distance(const Vec3& a, const Vec3& b) { return norm(a - b); }

TEST(Waveforms, ASquareOf2HzAnd15PercentIsOn75TicksOf500) {
  const auto level = levels(vibration(Waveform::kSquare, 2, 0.15), 2000);
  for (int i = 0; i < 2000; ++i)
    ASSERT_EQ(level[static_cast<std::size_t>(i)], i % 500 < 75 ? 1.0 : 0.0) << i;
}

TEST(Waveforms, ASineStartsAtRestAndPeaksInTheMiddleOfItsPeriod) {
  const auto level = levels(vibration(Waveform::kSine, 10), 101);
  EXPECT_NEAR(level[0], 0.0, 1e-9);
  EXPECT_NEAR(level[25], 0.5, 1e-9);
  EXPECT_NEAR(level[50], 1.0, 1e-9);
  EXPECT_NEAR(level[100], 0.0, 1e-9);
}

TEST(Waveforms, ATriangleRisesAndFallsAndASawtoothOnlyRises) {
  const auto triangle = levels(vibration(Waveform::kTriangle, 10), 101);
  EXPECT_NEAR(triangle[25], 0.5, 1e-9);
  EXPECT_NEAR(triangle[50], 1.0, 1e-9);
  EXPECT_NEAR(triangle[75], 0.5, 1e-9);
  const auto sawtooth = levels(vibration(Waveform::kSawtooth, 10), 101);
  EXPECT_NEAR(sawtooth[50], 0.5, 1e-9);
  EXPECT_NEAR(sawtooth[99], 0.99, 1e-9);
  EXPECT_NEAR(sawtooth[100], 0.0, 1e-9);
}

TEST(Waveforms, NoiseWandersAndRepeatsExactly) {
  const auto noise = vibration(Waveform::kNoise, 100);
  const auto level = levels(noise, 5000);
  double sum = 0;
  double min_x = 1;
  double max_x = 0;
  for (const double x : level) {
    sum += x;
    min_x = std::min(min_x, x);
    max_x = std::max(max_x, x);
  }
  EXPECT_NEAR(sum / 5000, 0.5, 0.05);
  EXPECT_LT(min_x, 0.1);
  EXPECT_GT(max_x, 0.9);
  EXPECT_EQ(level, levels(noise, 5000));
}

TEST(Waveforms, TheRootMeanSquareIsThatOfALongRun) {
  for (const Waveform waveform : {Waveform::kConstant, Waveform::kSine, Waveform::kSquare,
                                  Waveform::kTriangle, Waveform::kSawtooth, Waveform::kNoise}) {
    const auto spec = vibration(waveform, 17.3, 0.3);
    double squares = 0;
    for (const double x : levels(spec, 200'000)) squares += x * x;
    EXPECT_NEAR(std::sqrt(squares / 200'000), rms_fraction(spec), 0.01)
        << static_cast<int>(waveform);
  }
}

RC_GTEST_PROP(Waveforms, StayBetweenRestAndStrength, ()) {
  const auto waveform = static_cast<Waveform>(*rc::gen::inRange(0, 6));
  auto spec =
      vibration(waveform, *rc::gen::inRange(5, 2501) / 10.0, *rc::gen::inRange(5, 96) / 100.0);
  spec.duration = *rc::gen::inRange(1, 600);
  spec.envelope = {*rc::gen::inRange(0, 600), *rc::gen::inRange(0, 600),
                   *rc::gen::inRange(0, 101) / 100.0, *rc::gen::inRange(0, 101) / 100.0};
  for (const double x : levels(spec, static_cast<int>(spec.duration)))
    RC_ASSERT(x >= 0.0 && x <= 1.0);
}

TEST(Envelopes, RiseAndFallLinearlyInsideTheDuration) {
  EffectSpec spec;
  spec.duration = 100;
  spec.envelope = {.attack = 20, .fade = 40};
  const auto level = levels(spec, 101);
  EXPECT_DOUBLE_EQ(level[0], 0.0);
  EXPECT_DOUBLE_EQ(level[10], 0.5);
  EXPECT_DOUBLE_EQ(level[20], 1.0);
  EXPECT_DOUBLE_EQ(level[60], 1.0);
  EXPECT_DOUBLE_EQ(level[80], 0.5);
  EXPECT_DOUBLE_EQ(level[100], 0.0);
}

TEST(Envelopes, StartAndEndAtTheirLevels) {
  EffectSpec spec;
  spec.duration = 100;
  spec.envelope = {.attack = 10, .fade = 10, .attack_level = 0.4, .fade_level = 0.2};
  const auto level = levels(spec, 101);
  EXPECT_DOUBLE_EQ(level[0], 0.4);
  EXPECT_DOUBLE_EQ(level[5], 0.7);
  EXPECT_DOUBLE_EQ(level[95], 0.6);
  EXPECT_DOUBLE_EQ(level[100], 0.2);
}

TEST(Envelopes, ALeasedEffectDoesNotFade) {
  EffectSpec spec;
  spec.duration = 0;
  spec.lease = 100;
  spec.envelope = {.attack = 0, .fade = 50};
  for (const double x : levels(spec, 100)) EXPECT_EQ(x, 1.0);
}

TEST(Circles, HaveFifteenStepsAtTheEquatorAndElevenAt45Degrees) {
  EXPECT_EQ(circle_steps(90), 15);
  EXPECT_EQ(circle_steps(45), 11);
  EXPECT_EQ(circle_steps(30), 8);
  EXPECT_EQ(circle_steps(0), 1);
  EXPECT_EQ(circle_steps(180), 1);
}

TEST(Circles, OfAnotherPitchHaveItsNumberOfSteps) {
  EXPECT_EQ(circle_steps(90, 36.0), 10);
  EXPECT_EQ(circle_steps(30, 36.0), 5);
  EffectSpec spec = circle();
  spec.trajectory.pitch_deg = 36.0;
  EXPECT_EQ(ring_of(spec.trajectory).steps, 10);
  EXPECT_EQ(carried(circle(), spec, {.steps = 7.5}).steps, 5.0) << "half way round stays half way";
}

TEST(Circles, AtTenPinsASecondStepTenTimesASecondFromTheFrontToTheLeft) {
  const auto at = directions(circle(), 1501);
  for (int i = 0; i < 1500; ++i) {
    const int step = i / 100;
    const double expected = 24.0 * step;
    const double angle = std::fmod(azimuth_deg(at[static_cast<std::size_t>(i)]) + 360.0, 360.0);
    ASSERT_NEAR(angle, expected, 1e-6) << i;
  }
  EXPECT_NEAR(distance(at[1500], {1, 0, 0}), 0.0, 1e-9);
}

TEST(Circles, ClockwiseGoesToTheRight) {
  auto spec = circle();
  spec.trajectory.clockwise = true;
  EXPECT_NEAR(azimuth_deg(directions(spec, 101)[100]), -24.0, 1e-6);
}

TEST(Circles, GlideWhenSmooth) {
  const auto at = directions(circle(90, 10, true), 101);
  EXPECT_NEAR(azimuth_deg(at[50]), 12.0, 1e-6);
  EXPECT_NEAR(azimuth_deg(at[100]), 24.0, 1e-6);
}

TEST(Circles, AboutTheFrontBeginAtTheTop) {
  auto spec = circle();
  spec.trajectory.axis = {1, 0, 0};
  const auto at = directions(spec, 101);
  EXPECT_NEAR(distance(at[0], {0, 0, 1}), 0.0, 1e-9);
  EXPECT_LT(at[100].y, 0.0) << "anticlockwise for somebody in front of the ball: top, right";
}

RC_GTEST_PROP(Circles, KeepTheirAngleFromTheAxis, ()) {
  auto spec = circle(*rc::gen::inRange(0, 181), *rc::gen::inRange(1, 1001) / 10.0,
                     *rc::gen::arbitrary<bool>());
  spec.trajectory.clockwise = *rc::gen::arbitrary<bool>();
  spec.trajectory.axis = unit_or({*rc::gen::inRange(-9, 10) * 1.0, *rc::gen::inRange(-9, 10) * 1.0,
                                  *rc::gen::inRange(-9, 10) * 1.0},
                                 {0, 0, 1});
  const double cosine = std::cos(spec.trajectory.ring_deg * 3.14159265358979 / 180);
  EffectPhase phase;
  phase.steps = 0;
  for (int i = 0; i < 300; ++i, phase = advanced(spec, phase)) {
    const Vec3 d = direction_at(spec.trajectory, phase);
    RC_ASSERT(std::abs(norm(d) - 1.0) < 1e-9);
    RC_ASSERT(std::abs(dot(d, spec.trajectory.axis) - cosine) < 1e-9);
    RC_ASSERT(phase.steps >= 0 && phase.steps < circle_steps(spec.trajectory.ring_deg));
  }
}

TEST(Updates, AWiderRingContinuesAtTheSameAngle) {
  const auto narrow = circle(45, 10, true);
  const auto wide = circle(90, 10, true);
  EffectPhase phase;
  phase.steps = 11.0 / 4;
  const auto carried_phase = carried(narrow, wide, phase);
  EXPECT_NEAR(azimuth_deg(direction_at(wide.trajectory, carried_phase)), 90.0, 1e-9);
}

TEST(Updates, AReversalContinuesFromThePresentAngle) {
  for (const bool smooth : {false, true}) {
    const auto there = circle(90, 10, smooth);
    auto back = there;
    back.trajectory.clockwise = true;
    EffectPhase phase;
    phase.steps = 3.25;
    auto carried_phase = carried(there, back, phase);
    EXPECT_NEAR(distance(direction_at(back.trajectory, carried_phase),
                         direction_at(there.trajectory, phase)),
                0.0, 1e-9);
    for (int i = 0; i < 100; ++i) carried_phase = advanced(back, carried_phase);
    EXPECT_NEAR(azimuth_deg(direction_at(back.trajectory, carried_phase)), smooth ? 54.0 : 48.0,
                1e-6);
  }
}

TEST(Updates, SkippedTicksPassAtOnce) {
  auto spec = circle(90, 7, true);
  spec.waveform = Waveform::kTriangle;
  spec.frequency_hz = 3;
  const Ring ring = ring_of(spec.trajectory);
  EffectPhase one_by_one;
  for (int i = 0; i < 37; ++i) one_by_one = advanced(spec, one_by_one);
  const EffectPhase at_once = advanced(spec, ring, {}, 37);
  EXPECT_EQ(at_once.elapsed, one_by_one.elapsed);
  EXPECT_NEAR(at_once.wave, one_by_one.wave, 1e-9);
  EXPECT_NEAR(at_once.steps, one_by_one.steps, 1e-9);
}

}  // namespace
}  // namespace hedgehog::model

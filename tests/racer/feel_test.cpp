// SPDX-License-Identifier: MIT
// Impacts as effect strengths, reduction of the strengths by the ball's heat, and driving by tilt.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "clients/racer/feel/gain.h"
#include "clients/racer/feel/steps.h"
#include "clients/racer/game/tilt.h"
#include "clients/racer/race_event_text.h"

namespace hedgehog::racer {
namespace {

/// Force JND of the study, as a ratio.
constexpr double kForceJnd = 1.13;
constexpr double kFelt = 2.1;
constexpr double kFull = 15.0;

TEST(Steps, AreDistinguishableAtFullAndReducedStrength) {
  for (const double gain : {1.0, Gain::kMin}) {
    EXPECT_DOUBLE_EQ(strength_of(0, kFelt, gain * kFull), kFelt);
    EXPECT_DOUBLE_EQ(strength_of(kSteps - 1, kFelt, gain * kFull), gain * kFull);
    for (int step = 1; step < kSteps; ++step) {
      const double ratio =
          strength_of(step, kFelt, gain * kFull) / strength_of(step - 1, kFelt, gain * kFull);
      EXPECT_GT(ratio, kForceJnd) << step;
      EXPECT_GT(ratio, 1.15) << step;
    }
  }
}

TEST(Steps, CoverTheImpulsesInEqualRatios) {
  EXPECT_EQ(step_of(0.0), 0);
  EXPECT_EQ(step_of(kMinHitImpulse), 0);
  EXPECT_EQ(step_of(kMaxHitImpulse), kSteps - 1);
  EXPECT_EQ(step_of(1e9), kSteps - 1);
  EXPECT_EQ(step_of(std::sqrt(kMinHitImpulse * kMaxHitImpulse) * 1.01), kSteps / 2);
}

RC_GTEST_PROP(Steps, NeverFallWithAHarderImpact, ()) {
  const double a = *rc::gen::inRange(0, 20'000);
  const double b = a + *rc::gen::inRange(0, 20'000);
  RC_ASSERT(step_of(a) <= step_of(b));
}

RC_GTEST_PROP(Steps, AreMonotonicAtAnyGain, ()) {
  const double full = 0.001 * *rc::gen::inRange(1, 15'001) * 0.01 * *rc::gen::inRange(40, 101);
  double previous = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    const double now = strength_of(step, kFelt, full);
    RC_ASSERT(now >= previous);
    previous = now;
  }
  double skid = kFelt;
  for (int tenth = 0; tenth <= 10; ++tenth) {
    const double now = skid_strength(0.1 * tenth, kFelt, full);
    RC_ASSERT(now >= skid);
    skid = now;
  }
}

TEST(PulseGate, PassesOnePerQuarterSecondUnlessAHarderOneFollows) {
  PulseGate gate;
  EXPECT_TRUE(gate.passes(3, 10.0));
  EXPECT_FALSE(gate.passes(3, 10.1));
  EXPECT_TRUE(gate.passes(4, 10.1));
  EXPECT_FALSE(gate.passes(3, 10.3));
  EXPECT_TRUE(gate.passes(0, 10.36));
  // A new race begins at 0.
  EXPECT_TRUE(gate.passes(0, 0.0));
}

RC_GTEST_PROP(PulseGate, NeverFiresFasterThanFourTimesASecondAndTheSteps, ()) {
  PulseGate gate;
  int through = 0;
  for (int frame = 0; frame < 600; ++frame)
    if (gate.passes(*rc::gen::inRange(0, kSteps), frame / 60.0)) ++through;
  RC_ASSERT(through <= 40 + 10 * kSteps);
}

TEST(GainRule, IsFullWhileTheBallHasAReserve) {
  Gain gain;
  for (int i = 0; i < 100; ++i)
    gain.take(false, i % 2 == 0 ? std::nullopt : std::optional(8.0), 0.1);
  EXPECT_EQ(gain.now(), 1.0);
}

TEST(GainRule, GoesDownWithinSecondsAndComesBackSlowly) {
  Gain gain;
  gain.take(true, 0.0, 0.5);
  EXPECT_NEAR(gain.now(), 0.7, 1e-9);
  for (int i = 0; i < 10; ++i) gain.take(true, 0.0, 0.5);
  EXPECT_EQ(gain.now(), Gain::kMin);
  gain.take(false, std::nullopt, 10.0);
  EXPECT_NEAR(gain.now(), 0.6, 1e-9);
  for (int i = 0; i < 30; ++i) gain.take(false, std::nullopt, 1.0);
  EXPECT_EQ(gain.now(), 1.0);
}

TEST(GainRule, FollowsTheBurstBeforeTheDaemonHasToReduce) {
  Gain gain;
  for (int i = 0; i < 100; ++i) gain.take(false, 1.5, 0.1);
  EXPECT_NEAR(gain.now(), 0.85, 1e-9);
  for (int i = 0; i < 100; ++i) gain.take(false, 0.0, 0.1);
  EXPECT_NEAR(gain.now(), Gain::kZeroReserveGain, 1e-9);
}

TEST(TiltRule, LeftAndRightSteerForwardIsThrottleAndBackIsBrake) {
  const Tilt tilt;
  EXPECT_EQ(tilt.controls({}), Controls{});
  EXPECT_EQ(tilt.controls(model::axis_angle({0, 0, 1}, 130)), Controls{});
  // A rotation about x lifts the left side, which steers to the right.
  EXPECT_NEAR(tilt.controls(model::axis_angle({1, 0, 0}, 17)).steer, 0.5, 1e-9);
  EXPECT_NEAR(tilt.controls(model::axis_angle({1, 0, 0}, -17)).steer, -0.5, 1e-9);
  // A rotation about y lowers the front, which is throttle.
  EXPECT_NEAR(tilt.controls(model::axis_angle({0, 1, 0}, 17)).throttle, 0.5, 1e-9);
  EXPECT_NEAR(tilt.controls(model::axis_angle({0, 1, 0}, -30)).brake, 1.0, 1e-9);
  EXPECT_EQ(tilt.controls(model::axis_angle({0, 1, 0}, -30)).throttle, 0.0);
}

TEST(TiltRule, HasADeadZoneAndAnEnd) {
  const Tilt tilt;
  EXPECT_EQ(tilt.controls(model::axis_angle({1, 0, 0}, 3.9)).steer, 0.0);
  EXPECT_NEAR(tilt.controls(model::axis_angle({1, 0, 0}, 31)).steer, 1.0, 1e-9);
  EXPECT_NEAR(tilt.controls(model::axis_angle({1, 0, 0}, 80)).steer, 1.0, 1e-9);
}

TEST(TiltRule, IsRelativeToTheInitialPoseForAnyHeading) {
  for (const double yaw : {0.0, 77.0, -160.0}) {
    const model::Quaternion turned = model::axis_angle({0, 0, 1}, yaw);
    const model::Quaternion held = turned * model::axis_angle({0, 1, 0}, -25);
    Tilt tilt;
    tilt.recentre(held);
    EXPECT_EQ(tilt.controls(held), Controls{});
    const Controls forward = tilt.controls(turned * model::axis_angle({0, 1, 0}, -8));
    EXPECT_NEAR(forward.throttle, 0.5, 1e-6);
    EXPECT_NEAR(forward.steer, 0.0, 1e-6);
  }
}

TEST(ReportedEvents, AreOneJsonObjectEach) {
  EXPECT_EQ(to_json(Hit{{0.6, -0.8, 0}, 812.5}, 2.5),
            R"({"time_s":2.5,"type":"hit","direction":[0.6,-0.8,0],"impulse_n_s":812.5})");
  EXPECT_EQ(to_json(Skid{0.25}, 1), R"({"time_s":1,"type":"skid","amount":0.25})");
  EXPECT_EQ(to_json(Tumble{{0, 1, 0}}, 1), R"({"time_s":1,"type":"tumble","down":[0,1,0]})");
  EXPECT_EQ(to_json(LapDone{2, 26.5}, 60),
            R"({"time_s":60,"type":"lap","lap":2,"lap_time_s":26.5})");
  EXPECT_EQ(to_json(Reset{}, 3), R"({"time_s":3,"type":"reset"})");
}

TEST(ReportedEvents, SidesAreNamedByEighths) {
  EXPECT_EQ(side_of({1, 0.1, 0}), "front");
  EXPECT_EQ(side_of({0.7, 0.7, 0}), "front left");
  EXPECT_EQ(side_of({-0.7, -0.7, 0.2}), "back right");
  EXPECT_EQ(side_of({0.1, 0, 1}), "roof");
}

TEST(ReportedEvents, OfADurationAreReportedAtItsEnd) {
  RaceEventLog log;
  EXPECT_TRUE(log.lines({Skid{0.3}}, 1.0).empty());
  EXPECT_TRUE(log.lines({Skid{0.6}}, 1.5).empty());
  EXPECT_EQ(log.lines({}, 2.0),
            std::vector<std::string>{"   2.00 s  skid, 1.0 s long, up to 60 %"});
  EXPECT_TRUE(log.lines({}, 2.5).empty());
}

}  // namespace
}  // namespace hedgehog::racer

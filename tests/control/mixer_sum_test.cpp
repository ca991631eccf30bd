// SPDX-License-Identifier: MIT
// The sum of the effects, its frame, and the report of their delivery (protocol/README.md: mixing,
// frames, `effect_ended`).
#include <gtest/gtest.h>

#include "daemon/control/effects/mixer.h"
#include "tests/control/mixer_harness.h"

namespace hedgehog::control {
namespace {

using model::Vec3;

struct MixerSumTest : testing::Test, MixerHarness {
  static model::EffectSpec with_priority(model::EffectSpec spec, std::uint8_t priority) {
    spec.priority = priority;
    return spec;
  }
  static model::EffectSpec in(model::Frame frame, model::EffectSpec spec) {
    spec.frame = frame;
    return spec;
  }
  static void expect_near(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(norm(a - b), 0.0, 1e-9) << a.x << ' ' << a.y << ' ' << a.z;
  }
};

TEST_F(MixerSumTest, EffectsOfOnePriorityAddAsVectors) {
  start(hold({1, 0, 0}, 3));
  start(hold({0, 1, 0}, 4));
  EXPECT_EQ(tick(), (Vec3{3, 4, 0}));
}

TEST_F(MixerSumTest, OppositeOnesCancel) {
  start(hold({1, 0, 0}, 5));
  start(hold({-1, 0, 0}, 5));
  EXPECT_EQ(tick(), Vec3());
  EXPECT_TRUE(last.any);
}

TEST_F(MixerSumTest, TheSumIsLeftToTheLimiter) {
  for (int i = 0; i < 4; ++i) start(hold({1, 0, 0}, 15));
  EXPECT_EQ(tick().x, 60.0);
}

TEST_F(MixerSumTest, OnlyTheHighestPriorityPlaysAndTheOthersResume) {
  const auto engine = start(hold({1, 0, 0}, 3, 1000));
  run(10);
  const auto crash = start(with_priority(pulse({0, 1, 0}, 9, 100), 7));
  const auto demand = run(101);
  EXPECT_EQ(demand[0], (Vec3{0, 9, 0}));
  EXPECT_EQ(demand[100], (Vec3{3, 0, 0}));
  run(1000);
  EXPECT_EQ(reason_of(crash), EndReason::kCompleted);
  EXPECT_EQ(reason_of(engine), EndReason::kExpired);
  EXPECT_EQ(end_of(engine)->delivery.masked, 100);
  EXPECT_EQ(end_of(engine)->delivery.offset, 2000);
}

TEST_F(MixerSumTest, AMaskedEffectIsNotPlayingAndHasNoShare) {
  const auto low = start(hold());
  const auto high = start(with_priority(hold({0, 1, 0}, 8), 6));
  tick();
  EXPECT_FALSE(status_of(low).playing);
  EXPECT_EQ(status_of(low).current_a, 0.0);
  EXPECT_EQ(status_of(low).remaining, 1000);
  EXPECT_TRUE(status_of(high).playing);
  EXPECT_EQ(status_of(high).current_a, 8.0);
}

TEST_F(MixerSumTest, AWaitingEffectMasksNoOther) {
  start(hold({1, 0, 0}, 5));
  auto later = with_priority(pulse({0, 1, 0}), 7);
  later.delay = 50;
  start(later);
  EXPECT_EQ(tick(), (Vec3{5, 0, 0}));
}

TEST_F(MixerSumTest, AnEffectThatEndsWithoutAPlayedTickIsPreempted) {
  start(with_priority(hold({0, 1, 0}, 5, 5000), 7));
  const auto timed = start(pulse({1, 0, 0}, 5, 50));
  const auto leased = start(hold({1, 0, 0}, 5, 200));
  const auto stopped = start(hold({1, 0, 0}, 5, 5000));
  run(300);
  stop(stopped);
  tick();
  EXPECT_EQ(reason_of(timed), EndReason::kPreempted);
  EXPECT_EQ(reason_of(leased), EndReason::kPreempted);
  EXPECT_EQ(reason_of(stopped), EndReason::kStopped);
  EXPECT_EQ(end_of(timed)->delivery.masked, 50);
  EXPECT_EQ(end_of(timed)->delivery.mean, 0.0);
}

TEST_F(MixerSumTest, AnEffectWithOnePlayedTickIsNotPreempted) {
  const auto effect = start(pulse({1, 0, 0}, 5, 50));
  tick();
  start(with_priority(hold({0, 1, 0}), 7));
  run(60);
  EXPECT_EQ(reason_of(effect), EndReason::kCompleted);
}

TEST_F(MixerSumTest, DeliveredIsTheShareThatTheLimiterPasses) {
  const auto effect = start(pulse({1, 0, 0}, 15, 100));
  run(50);
  passed = 0.6;
  tick();
  EXPECT_NEAR(status_of(effect).current_a, 9.0, 1e-12);
  run(50);
  const auto delivery = end_of(effect)->delivery;
  EXPECT_NEAR(delivery.min, 0.6, 1e-12);
  EXPECT_NEAR(delivery.mean, 0.8, 1e-12);
}

TEST_F(MixerSumTest, ARequestOfZeroCountsAsDelivered) {
  auto spec = pulse({1, 0, 0}, 5, 100);
  spec.waveform = model::Waveform::kSquare;
  spec.frequency_hz = 10;
  const auto effect = start(spec);
  for (int i = 0; i <= 100; ++i) {
    passed = i < 50 ? 1.0 : 0.0;
    tick();
  }
  EXPECT_EQ(end_of(effect)->delivery.min, 1.0);
}

TEST_F(MixerSumTest, TheOwnersGainIsNoLoss) {
  const auto effect = start(pulse({1, 0, 0}, 10, 10));
  inputs.gain = 0.5;
  run(5);
  EXPECT_EQ(status_of(effect).current_a, 5.0);
  run(10);
  EXPECT_EQ(end_of(effect)->delivery.min, 1.0);
}

TEST_F(MixerSumTest, MixedCountsTheTicksInWhichOthersAdded) {
  const auto first = start(pulse({1, 0, 0}, 5, 100));
  run(40);
  const auto second = start(pulse({0, 1, 0}, 5, 30));
  const auto silent = start(pulse({0, 1, 0}, 0, 100));
  run(101);
  EXPECT_EQ(end_of(first)->delivery.mixed, 30);
  EXPECT_EQ(end_of(second)->delivery.mixed, 30);
  EXPECT_EQ(end_of(silent)->delivery.mixed, 60) << "while at least one other was felt";
}

TEST_F(MixerSumTest, WorldEffectsTurnAgainstTheBall) {
  start(in(model::Frame::kWorld, hold({0, 0, 1}, 5)));
  inputs.device_to_world = model::axis_angle({1, 0, 0}, 90);
  expect_near(tick(), {0, 5, 0});
  inputs.device_to_world = model::axis_angle({1, 0, 0}, 180);
  expect_near(tick(), {0, 0, -5});
}

TEST_F(MixerSumTest, WithoutOrientationTheyFadeIn200MsAndResumeWithIt) {
  const auto effect = start(in(model::Frame::kWorld, hold({0, 0, 1}, 10, 10'000)));
  run(300);
  inputs.orientation_usable = false;
  auto demand = run(300);
  EXPECT_NEAR(demand[0].z, 9.95, 1e-6);
  EXPECT_NEAR(demand[99].z, 5.0, 1e-6);
  EXPECT_GT(demand[198].z, 0.0);
  EXPECT_EQ(demand[199].z, 0.0);
  EXPECT_FALSE(status_of(effect).playing);
  inputs.orientation_usable = true;
  demand = run(200);
  EXPECT_NEAR(demand[99].z, 5.0, 1e-6);
  EXPECT_EQ(demand[199].z, 10.0);
  EXPECT_FALSE(end_of(effect).has_value());
}

TEST_F(MixerSumTest, TheFadeCountsAsNotDelivered) {
  const auto effect = start(in(model::Frame::kWorld, pulse({0, 0, 1}, 10, 400)));
  run(200);
  inputs.orientation_usable = false;
  run(201);
  EXPECT_EQ(end_of(effect)->delivery.min, 0.0);
  EXPECT_NEAR(end_of(effect)->delivery.mean, 0.75, 0.01);
}

TEST_F(MixerSumTest, WithoutOrientationForTwoSecondsTheyEnd) {
  const auto world = start(in(model::Frame::kWorld, hold({0, 0, 1}, 5, 10'000)));
  const auto device = start(hold({1, 0, 0}, 5, 10'000));
  run(10);
  inputs.orientation_usable = false;
  run(1999);
  EXPECT_FALSE(end_of(world).has_value());
  tick();
  EXPECT_EQ(reason_of(world), EndReason::kOrientationLost);
  EXPECT_FALSE(end_of(device).has_value());
}

TEST_F(MixerSumTest, AFadedWorldEffectMasksNoOther) {
  start(with_priority(in(model::Frame::kWorld, hold({0, 0, 1}, 5, 10'000)), 7));
  start(hold({1, 0, 0}, 4, 10'000));
  inputs.orientation_usable = true;
  EXPECT_EQ(tick(), (Vec3{0, 0, 5}));
  inputs.orientation_usable = false;
  EXPECT_EQ(run(200)[199], (Vec3{4, 0, 0}));
}

TEST_F(MixerSumTest, CoilEffectsAddressWindingsAndBypassTheMatrix) {
  start(in(model::Frame::kCoil, hold({0, 1, 0}, 4)));
  start(hold({1, 0, 0}, 3));
  inputs.device_to_world = model::axis_angle({0, 0, 1}, 90);
  EXPECT_EQ(tick(), (Vec3{3, 0, 0}));
  EXPECT_EQ(last.coil_a, (Vec3{0, 4, 0}));
}

}  // namespace
}  // namespace hedgehog::control

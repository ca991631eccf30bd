// SPDX-License-Identifier: MIT
// Start and end of effects: shapes, ends and slots of protocol/README.md.
#include "daemon/control/effects/mixer.h"

#include <gtest/gtest.h>

#include "tests/control/mixer_harness.h"

namespace hedgehog::control {
namespace {

using model::Vec3;
using model::Waveform;

struct MixerTest : testing::Test, MixerHarness {
  void expect_end(EffectId effect, EndReason reason, model::Tick offset) {
    const auto event = end_of(effect);
    ASSERT_TRUE(event.has_value()) << "effect " << effect << " has not ended";
    EXPECT_EQ(event->end_reason, reason);
    EXPECT_EQ(event->delivery.offset, offset);
    EXPECT_EQ(event->tick, offset);
  }
};

TEST_F(MixerTest, WithoutEffectsNoForceIsRequested) {
  EXPECT_EQ(tick(), Vec3());
  EXPECT_FALSE(last.any);
  EXPECT_TRUE(mixer.empty());
  EXPECT_TRUE(events.empty());
}

TEST_F(MixerTest, APulsePlaysFromTheTickOfItsStartForItsDuration) {
  const auto effect = start(pulse({0, 1, 0}, 7, 150));
  const auto demand = run(151);
  EXPECT_EQ(demand[0], (Vec3{0, 7, 0}));
  EXPECT_EQ(demand[149], (Vec3{0, 7, 0}));
  EXPECT_EQ(demand[150], Vec3());
  expect_end(effect, EndReason::kCompleted, 1150);
  EXPECT_EQ(end_of(effect)->delivery.onset, 1000);
}

TEST_F(MixerTest, TheStartIsReportedWithItsSequenceNumber) {
  const auto effect = start(pulse());
  tick();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].type, EventType::kEffectStarted);
  EXPECT_EQ(events[0].effect, effect);
  EXPECT_EQ(events[0].seq, 101U);
  EXPECT_EQ(events[0].tick, 1000);
}

TEST_F(MixerTest, GainScalesOneEffectAndTheOwnersGainAll) {
  auto spec = pulse({1, 0, 0}, 10);
  spec.gain = 0.5;
  start(spec);
  inputs.gain = 0.2;
  EXPECT_DOUBLE_EQ(tick().x, 1.0);
}

TEST_F(MixerTest, ADelayedEffectWaitsAndThenPlaysItsWholeDuration) {
  auto spec = pulse({1, 0, 0}, 5, 30);
  spec.delay = 20;
  const auto effect = start(spec);
  tick();
  EXPECT_FALSE(status_of(effect).playing);
  EXPECT_EQ(status_of(effect).remaining, 50);
  const auto demand = run(60);
  EXPECT_EQ(demand[18].x, 0.0);
  EXPECT_EQ(demand[19].x, 5.0);
  expect_end(effect, EndReason::kCompleted, 1050);
  EXPECT_EQ(end_of(effect)->delivery.onset, 1020);
}

TEST_F(MixerTest, AnEffectStartsAtItsTickAndAtOnceWhenThatIsPast) {
  auto spec = pulse({1, 0, 0}, 5, 10);
  spec.start_at = 1007;
  const auto later = start(spec);
  spec.start_at = 900;
  const auto late = start(spec);
  run(20);
  EXPECT_EQ(end_of(later)->delivery.onset, 1007);
  EXPECT_EQ(end_of(late)->delivery.onset, 1000);
}

TEST_F(MixerTest, ALeaseExpiresUnlessItIsRenewed) {
  const auto effect = start(hold({1, 0, 0}, 5, 100));
  run(80);
  update(effect, hold({0, 1, 0}, 3, 100));
  EXPECT_EQ(tick(), (Vec3{0, 3, 0}));
  run(200);
  expect_end(effect, EndReason::kExpired, 1180);
}

TEST_F(MixerTest, ALeaseCountsFromTheOnset) {
  auto spec = hold({1, 0, 0}, 5, 100);
  spec.delay = 300;
  const auto effect = start(spec);
  run(500);
  expect_end(effect, EndReason::kExpired, 1400);
  EXPECT_EQ(end_of(effect)->delivery.onset, 1300);
}

TEST_F(MixerTest, AnUpdateDoesNotProlongATimedEffect) {
  const auto effect = start(pulse({1, 0, 0}, 5, 100));
  run(60);
  update(effect, pulse({1, 0, 0}, 9, 100));
  EXPECT_EQ(tick().x, 9.0);
  run(60);
  expect_end(effect, EndReason::kCompleted, 1100);
}

TEST_F(MixerTest, AnUpdateOfAnEffectThatHasEndedIsIgnored) {
  const auto effect = start(pulse({1, 0, 0}, 5, 10));
  run(20);
  update(effect, pulse({1, 0, 0}, 5, 10));
  EXPECT_EQ(tick(), Vec3());
  EXPECT_EQ(events.size(), 2U);
}

TEST_F(MixerTest, AStopEndsAtOnce) {
  const auto effect = start(hold());
  run(10);
  stop(effect);
  EXPECT_EQ(tick(), Vec3());
  expect_end(effect, EndReason::kStopped, 1010);
  EXPECT_TRUE(mixer.empty());
}

TEST_F(MixerTest, AStopBeforeItsStartIsStillApplied) {
  stop(1);
  tick();
  const auto effect = start(hold());
  EXPECT_EQ(tick(), Vec3());
  expect_end(effect, EndReason::kStopped, 1001);
  EXPECT_EQ(end_of(effect)->delivery.onset, -1);
  EXPECT_EQ(end_of(effect)->delivery.mean, 0.0);
}

TEST_F(MixerTest, AStopOfAnEarlierEffectInThePlaceDoesNotEndThisOne) {
  stop(1 + kEffectPlaces);
  const auto effect = start(hold());
  run(5);
  EXPECT_FALSE(end_of(effect).has_value());
}

TEST_F(MixerTest, WhenTheConnectionEndsItsEffectsEnd) {
  const auto effect = start(hold());
  run(10);
  stop(effect, EndReason::kDisconnected);
  EXPECT_EQ(tick(), Vec3());
  expect_end(effect, EndReason::kDisconnected, 1010);
}

TEST_F(MixerTest, AShortTimedEffectMayPlayOutAfterItsConnection) {
  auto spec = pulse({1, 0, 0}, 5, 2000);
  spec.finish_on_close = true;
  const auto effect = start(spec);
  stop(effect, EndReason::kDisconnected);
  run(2001);
  expect_end(effect, EndReason::kCompleted, 3000);
}

TEST_F(MixerTest, AShortTimedEffectMayPlayOutEvenIfItStartsAfterItsConnectionEnded) {
  stop(1, EndReason::kDisconnected);
  auto spec = pulse({1, 0, 0}, 5, 150);
  spec.finish_on_close = true;
  const auto effect = start(spec);
  EXPECT_EQ(tick().x, 5.0);
  run(150);
  expect_end(effect, EndReason::kCompleted, 1150);
}

TEST_F(MixerTest, ALongOrLeasedEffectMayNotPlayOut) {
  auto longer = pulse({1, 0, 0}, 5, 2001);
  longer.finish_on_close = true;
  auto leased = hold();
  leased.finish_on_close = true;
  const auto first = start(longer);
  const auto second = start(leased);
  tick();
  stop(first, EndReason::kDisconnected);
  stop(second, EndReason::kDisconnected);
  EXPECT_EQ(tick(), Vec3());
  expect_end(first, EndReason::kDisconnected, 1001);
  expect_end(second, EndReason::kDisconnected, 1001);
}

TEST_F(MixerTest, AStopEndsAnEffectThatPlaysOut) {
  auto spec = pulse({1, 0, 0}, 5, 500);
  spec.finish_on_close = true;
  const auto effect = start(spec);
  stop(effect, EndReason::kDisconnected);
  tick();
  stop(effect);
  EXPECT_EQ(tick(), Vec3());
  expect_end(effect, EndReason::kStopped, 1001);
}

TEST_F(MixerTest, AReplacementTakesOverInTheSameTickAndInPhase) {
  const auto first = start(vibration(Waveform::kSawtooth, 10));
  run(30);
  const auto second = start(vibration(Waveform::kSawtooth, 20), first);
  EXPECT_NEAR(tick().x, 5 * 0.31, 1e-9) << "29 ticks at 10 Hz, one at 20 Hz";
  expect_end(first, EndReason::kReplaced, 1030);
  EXPECT_EQ(end_of(first)->delivery.masked, 0);
  EXPECT_TRUE(status_of(second).playing);
}

TEST_F(MixerTest, ReplacingEveryTickOrTwiceInATickKeepsThePhase) {
  auto spec = vibration(Waveform::kSawtooth, 10);
  spec.envelope.attack = 50;
  EffectId playing = start(spec);
  for (int i = 0; i < 60; ++i) {
    tick();
    playing = start(spec, start(spec, playing));
  }
  EXPECT_NEAR(tick().x, 5 * 0.60, 1e-9);
}

TEST_F(MixerTest, AnotherWaveformStartsFromItsBeginning) {
  const auto first = start(vibration(Waveform::kSawtooth, 10));
  run(30);
  start(vibration(Waveform::kTriangle, 10), first);
  EXPECT_NEAR(tick().x, 0.0, 1e-9);
}

TEST_F(MixerTest, AReplacedCircleContinuesFromItsPin) {
  auto spec = pulse({1, 0, 0}, 5, 5000);
  spec.method = model::EffectMethod::kCircle;
  spec.trajectory.path = model::Path::kCircle;
  const auto first = start(spec);
  const Vec3 before = run(350)[349];
  EXPECT_NEAR(std::atan2(before.y, before.x), 72 * 0.0174532925, 1e-6);
  spec.trajectory.speed_pins_s = 20;
  start(spec, first);
  EXPECT_EQ(tick(), before);
  const Vec3 after = run(25)[24];
  EXPECT_NEAR(std::atan2(after.y, after.x), 96 * 0.0174532925, 1e-6);
}

TEST_F(MixerTest, AnEffectResentEveryFrameContinuesItsAttack) {
  auto spec = vibration(Waveform::kConstant, 60, 250);
  spec.envelope.attack = 100;
  EffectId playing = start(spec);
  for (int frame = 0; frame < 10; ++frame) {
    run(16);
    playing = start(spec, playing);
  }
  EXPECT_DOUBLE_EQ(tick().x, 5.0);
}

TEST_F(MixerTest, ATimedReplacementPlaysItsOwnDuration) {
  const auto first = start(pulse({1, 0, 0}, 5, 100));
  run(90);
  const auto second = start(pulse({1, 0, 0}, 5, 100), first);
  run(101);
  expect_end(second, EndReason::kCompleted, 1190);
}

TEST_F(MixerTest, WhenTheBallIsNotArmedEverythingEndsAsTripped) {
  const auto playing = start(hold());
  auto delayed = pulse();
  delayed.delay = 5000;
  const auto waiting = start(delayed);
  tick();
  inputs.playable = false;
  EXPECT_EQ(tick(), Vec3());
  expect_end(playing, EndReason::kTripped, 1001);
  expect_end(waiting, EndReason::kTripped, 1001);
  const auto late = start(hold());
  EXPECT_EQ(tick(), Vec3());
  expect_end(late, EndReason::kTripped, 1002);
}

TEST_F(MixerTest, SkippedTicksAdvanceTheEffects) {
  const auto timed = start(pulse({1, 0, 0}, 5, 100));
  const auto leased = start(hold({1, 0, 0}, 5, 100));
  run(10);
  inputs.tick += 200;
  EXPECT_EQ(tick(), Vec3());
  EXPECT_EQ(reason_of(timed), EndReason::kCompleted);
  EXPECT_EQ(reason_of(leased), EndReason::kExpired);
}

}  // namespace
}  // namespace hedgehog::control

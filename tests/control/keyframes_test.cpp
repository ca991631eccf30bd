// SPDX-License-Identifier: MIT
// effect.play in the control loop: the demand of each tick, the end, and the replay of its
// recording.
#include <gtest/gtest.h>

#include <cmath>

#include "daemon/control/recording/recording.h"
#include "tests/control/mixer_harness.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

using model::Vec3;

/// Rises over 40 ms, falls over 60 ms, in front; 100 ms in total.
constexpr LoadKeyframes kBump{.first = 30,
                              .count = 3,
                              .frames = {{{1, 0, 0, 0, 0, model::Ease::kLinear},
                                          {1, 0, 0, 1, 40, model::Ease::kLinear},
                                          {1, 0, 0, 0, 100, model::Ease::kLinear}}}};

model::EffectSpec play(double rate = 1.0) {
  model::EffectSpec spec;
  spec.method = model::EffectMethod::kPlay;
  spec.trajectory.path = model::Path::kKeyframes;
  spec.trajectory.playback = {.first = 30,
                              .count = 3,
                              .length_ms = 100,
                              .ends_with_pattern = true,
                              .rate = rate,
                              .turn = {}};
  spec.duration = model::ticks_to_end(spec.trajectory.playback, 0);
  return spec;
}

model::EffectSpec looped(model::Tick lease = 1000) {
  model::EffectSpec spec = play();
  spec.trajectory.playback.loop = true;
  spec.trajectory.playback.ends_with_pattern = false;
  spec.duration = 0;
  spec.lease = lease;
  return spec;
}

class PlayTest : public testing::Test, public MixerHarness {
 protected:
  void SetUp() override { mixer.load(kBump); }
  Event ended(EffectId effect) const { return end_of(effect).value_or(Event{}); }
};

TEST_F(PlayTest, RequestsTheForceOfTheKeyFrames) {
  const auto effect = start(play());
  for (int i = 0; i < 100; ++i) {
    const double level = i < 40 ? i / 40.0 : (100 - i) / 60.0;
    EXPECT_NEAR(tick().x, 5 * level, 1e-6) << i;
  }
  EXPECT_EQ(tick(), Vec3());
  EXPECT_EQ(ended(effect).end_reason, EndReason::kCompleted);
  EXPECT_EQ(ended(effect).delivery.offset, 1100);
}

TEST_F(PlayTest, IsTurned) {
  auto spec = play();
  spec.trajectory.playback.turn = model::turn_from_front({0, 1, 0});
  start(spec);
  run(40);
  const Vec3 demand = tick();
  EXPECT_NEAR(demand.y, 5, 1e-6);
  EXPECT_NEAR(demand.x, 0, 1e-6);
}

TEST_F(PlayTest, TwiceAsFastIsOverInHalfTheTime) {
  const auto effect = start(play(2));
  run(20);
  EXPECT_NEAR(tick().x, 5, 1e-6);
  run(30);
  EXPECT_EQ(ended(effect).delivery.offset, 1050);
}

TEST_F(PlayTest, AChangedRateStillEndsWithThePattern) {
  const auto effect = start(play());
  run(41);
  update(effect, play(0.5));
  run(200);
  EXPECT_EQ(ended(effect).end_reason, EndReason::kCompleted);
  EXPECT_EQ(ended(effect).delivery.offset, 1000 + 40 + 120);
}

TEST_F(PlayTest, ALoopRepeatsUntilItsLeaseExpires) {
  const auto effect = start(looped(1000));
  const auto demands = run(1000);
  for (std::size_t i = 100; i < 1000; ++i) ASSERT_NEAR(demands[i].x, demands[i - 100].x, 1e-6) << i;
  EXPECT_EQ(tick(), Vec3());
  EXPECT_EQ(ended(effect).end_reason, EndReason::kExpired);
}

TEST_F(PlayTest, ALoopRenewedEveryFrameKeepsItsPhase) {
  EffectId playing = start(looped(250));
  run(30);
  for (int i = 0; i < 3; ++i) {
    playing = start(looped(250), playing);
    EXPECT_NEAR(tick().x, 5 * (30 + i) / 40.0, 1e-6);
  }
}

TEST_F(PlayTest, APatternThatIsStartedTwiceIsFeltTwice) {
  const auto first = start(play());
  run(60);
  start(play(), first);
  EXPECT_NEAR(tick().x, 0, 1e-6);
  run(39);
  EXPECT_NEAR(tick().x, 5, 1e-6);
}

TEST_F(PlayTest, ALeasedPatternThatDoesNotLoopIsFeltTwiceToo) {
  auto once = looped(3000);
  once.trajectory.playback.loop = false;
  const auto first = start(once);
  run(300);
  EXPECT_EQ(tick(), Vec3()) << "it rests after its end";
  start(once, first);
  run(40);
  EXPECT_NEAR(tick().x, 5, 1e-6);
}

TEST_F(PlayTest, NewKeyFramesStartAtTheirBeginning) {
  const auto playing = start(looped());
  run(61);
  LoadKeyframes other = kBump;
  other.first = 200;
  mixer.load(other);
  auto spec = looped();
  spec.trajectory.playback.first = 200;
  update(playing, spec);
  EXPECT_NEAR(tick().x, 5 * 1 / 40.0, 1e-6);
}

TEST_F(PlayTest, TheWaveformAndTheEnvelopeModulateIt) {
  auto spec = play();
  spec.waveform = model::Waveform::kSquare;
  spec.frequency_hz = 50;
  spec.envelope.attack = 80;
  start(spec);
  run(44);
  EXPECT_NEAR(tick().x, 5 * (56.0 / 60) * (44.0 / 80), 1e-6);
  run(6);
  EXPECT_NEAR(tick().x, 0, 1e-9) << "the square is off";
}

TEST_F(PlayTest, KeyFramesBeyondTheCapacityAreNotRead) {
  LoadKeyframes beyond = kBump;
  beyond.first = kKeyframeCapacity - 1;
  mixer.load(beyond);
  auto spec = play();
  spec.trajectory.playback.first = kKeyframeCapacity - 1;
  spec.trajectory.playback.count = 60'000;
  start(spec);
  for (const Vec3& demand : run(100)) EXPECT_EQ(demand, Vec3());
}

TEST(PlayRecording, ReplaysBitForBitAlsoWithKeyFramesFromBeforeIt) {
  FlightRecorder recorder;
  rig::Rig rig;
  rig.recorder = &recorder;
  rig.run_until_armed();
  rig.command(kBump);
  for (int i = 0; i < 90; ++i) {
    if (i == 70) {
      LoadKeyframes other = kBump;
      other.frames[1].y = 0.6F;
      other.frames[1].x = 0.8F;
      rig.command(other);
    }
    model::EffectSpec spec = i % 2 == 0 ? play(1.0 + i * 0.01) : looped(100 + i);
    spec.trajectory.playback.turn = model::axis_angle({0, 0, 1}, i * 7.0);
    rig.start(spec);
    rig.run(100);
  }
  EXPECT_GT(rig.current_a(), 0.0);
  rig.set_faults(device::kSimSensorOpen);
  rig.run(100);
  ASSERT_TRUE(recorder.frozen());
  const ReplayResult result = replay(recorder.take(), {});
  EXPECT_EQ(result.error, ReplayError::kNone);
  EXPECT_EQ(result.different, 0u);
  EXPECT_GE(result.ticks, 6000u);
}

}  // namespace
}  // namespace hedgehog::control

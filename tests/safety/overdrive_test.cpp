// SPDX-License-Identifier: MIT
// A late host never causes more current than an effect requests: a set-point that stays applied
// must hold its current.
#include <algorithm>

#include "model/random_stream.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using model::Tick;

constexpr double kRequestedA = 8.0;
constexpr double kMaxA = 8.5;

struct Vibration {
  rig::Rig rig;
  double peak_a = 0.0;
  double above_half_ms = 0.0;

  Vibration() {
    rig.run_until_armed();
    model::EffectSpec spec = rig::hold({1, 0, 0}, kRequestedA);
    spec.waveform = model::Waveform::kSquare;
    spec.frequency_hz = 60.0;
    rig.start(spec);
  }
  void sample() {
    peak_a = std::max(peak_a, rig.current_a());
    if (rig.current_a() > 0.5 * kRequestedA) above_half_ms += 1.0;
  }
  void tick() {
    rig.tick();
    sample();
  }
  void skip_control(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) {
      rig.skip_control(1);
      sample();
    }
  }
  void freeze_host(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) {
      rig.freeze_host(1);
      sample();
    }
  }
  void expect_delivered(double seconds) {
    record();
    EXPECT_LT(peak_a, kMaxA);
    EXPECT_GT(peak_a, 0.9 * kRequestedA);
    EXPECT_NEAR(above_half_ms / (seconds * 1000.0), 0.5, 0.1) << "it still vibrates";
    EXPECT_EQ(name(rig.controller().state()), "armed") << "being late is no fault of the ball";
  }
  void record() const {
    ::testing::Test::RecordProperty("peak_ma", static_cast<int>(1000.0 * peak_a));
  }
};

TEST(Overdrive, AVibrationInTime) {
  Vibration vibration;
  for (int i = 0; i < 3000; ++i) vibration.tick();
  vibration.expect_delivered(3.0);
}

TEST(Overdrive, EveryThirdControlTickSkipped) {
  Vibration vibration;
  for (int i = 0; i < 1000; ++i) {
    vibration.tick();
    vibration.tick();
    vibration.skip_control(1);
  }
  vibration.expect_delivered(3.0);
}

TEST(Overdrive, EveryThirdFrameNeverSent) {
  Vibration vibration;
  for (int i = 0; i < 1000; ++i) {
    vibration.tick();
    vibration.tick();
    vibration.freeze_host(1);
  }
  vibration.expect_delivered(3.0);
}

TEST(Overdrive, ControlAndLinkPauseAtRandom) {
  Vibration vibration;
  model::RandomStream random(7);
  Tick ran = 0;
  while (ran < 8000) {
    vibration.tick();
    const Tick late = random.uniform(0.0, 1.0) < 0.2 ? static_cast<Tick>(random.uniform(1, 8)) : 0;
    if (random.bits() % 2 == 0)
      vibration.skip_control(late);
    else
      vibration.freeze_host(late);
    ran += 1 + late;
  }
  vibration.expect_delivered(static_cast<double>(ran) / 1000.0);
}

// The defect that this file tests: the voltage that reaches the current within a millisecond gives
// 26 A if it stays applied.
TEST(Overdrive, ControlThatStopsRightAfterAStepHoldsTheRequest) {
  for (const double requested_a : {3.0, 8.0, 15.0}) {
    rig::Rig rig;
    rig.run_until_armed();
    rig.start(rig::hold({1, 0, 0}, requested_a));
    rig.tick();
    for (int ms = 0; ms < device::Link::kOverdueTicks; ++ms) {
      rig.skip_control(1);
      ASSERT_LT(rig.current_a(), 1.02 * requested_a) << ms << " ms late";
    }
    EXPECT_TRUE(asleep(rig));
  }
}

}  // namespace
}  // namespace hedgehog::safety

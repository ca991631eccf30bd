// SPDX-License-Identifier: MIT
// Laws over random requests and random faults: no coil stays driven without a request or while the
// ball is not armed, and no winding burns.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "daemon/device/simulator/simulator_settings.h"
#include "tests/rig/hours.h"
#include "tests/rig/random_requests.h"
#include "tests/rig/rig.h"
#include "tests/rig/sanitized.h"
#include "tests/rig/thermal_ball.h"

namespace hedgehog::safety {
namespace {

/// Maximum duration of a current that no effect requests: in the worst case the cable is unplugged,
/// and the board's dead-man takes 100 ms, its supply switch over a stuck bridge 20 more, and 5 L/R
/// with L 20 % above nominal. (For single faults see hardware_faults_test.cpp.)
constexpr model::Tick kLongest = 100 + 2 + 20 + 21 + 2;

RC_GTEST_PROP(RandomFaults, NeverLeaveACoilDriven, (std::uint64_t seed)) {
  model::RandomStream random(seed);
  rig::RigOptions options;
  options.board = rig::random_board(random);
  rig::Rig rig(options);
  rig.orient({});
  rig.run_until_armed();
  rig::Temper temper = rig::Temper::draw(random);
  temper.mean_length_s = 0.1;
  model::Tick unrequested = 0;
  const auto step = [&] {
    rig.tick();
    const bool idle =
        rig.controller().effects_empty() || rig.controller().state() != control::State::kArmed;
    unrequested = idle && rig.current_a() > 0.1 ? unrequested + 1 : 0;
    RC_ASSERT(unrequested <= kLongest);
    if (idle) RC_ASSERT(!rig.last_command().enable());
    RC_ASSERT(rig.plant().hottest_winding_c() < rig::kHottestAllowedC);
  };
  control::EffectId effect = 0;
  for (int round = 0; round < 60; ++round) {
    switch (random.bits() % 8) {
      case 0:
        rig.set_faults(static_cast<std::uint16_t>(1u << (random.bits() % 13)),
                       static_cast<int>(random.bits() % 3));
        break;
      case 1:
        rig.set_faults(0);
        rig.arm();
        break;
      case 2:
        rig.stop(effect);
        break;
      case 3:
        rig.drop_telemetry(static_cast<int>(random.bits() % 150));
        break;
      case 4:
        rig.skip_control(static_cast<model::Tick>(random.bits() % 40));
        break;
      case 5:
        if (random.bits() % 4 == 0) rig.emergency_stop();
        break;
      default: {
        model::EffectSpec spec = rig::random_effect(random, temper);
        if (random.bits() % 4 == 0) spec.frame = model::Frame::kWorld;
        effect = rig.start(spec);
        break;
      }
    }
    for (std::uint64_t i = random.bits() % 80; i > 0; --i) step();
  }
  rig.set_faults(0);
  for (model::Tick i = 0; i < 10'200; ++i) step();  // the longest effect ends
  RC_ASSERT(rig.controller().effects_empty());
  RC_ASSERT(rig.current_a() < 0.1);
}

// One sample of each kind of hour that the campaign runs in bulk.
TEST(RandomHours, OneOfEach) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    EXPECT_EQ(rig::thermal_hour(seed).failure, "") << "seed " << seed;
  EXPECT_EQ(rig::full_hour(1, 300.0).failure, "");
}

// The windings carry 5 A continuously on a ball that matches its device file.
class FiveAmpere : public ::testing::TestWithParam<model::Vec3> {};

// Under a sanitizer half an hour gives the same coverage as four.
constexpr int kDurationS = HEDGEHOG_SANITIZED != 0 ? 1800 : 4 * 3600;

TEST_P(FiveAmpere, ForFourHoursIsNeverReducedAndNeverTrips) {
  rig::Rig rig;
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold(GetParam(), 5.0));
  for (int second = 0; second < kDurationS; second += 5) {
    rig.update(effect, rig::hold(GetParam(), 5.0));
    rig.run(5000);
    ASSERT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
    ASSERT_NEAR(rig.current_a(), 5.0, 0.03) << second;  // a share of the noise
    ASSERT_FALSE(rig.snapshot().derating) << second;
  }
  EXPECT_EQ(rig.count(control::EventType::kDeratingStarted), 0);
  rig.stop(effect);
  rig.tick();
  EXPECT_EQ(rig.last(control::EventType::kEffectEnded)->delivery.min, 1.0);
}

std::string axis_name(const testing::TestParamInfo<model::Vec3>& axis) {
  constexpr const char* kNames[] = {"x", "y", "minus_z"};
  return kNames[axis.index];
}

INSTANTIATE_TEST_SUITE_P(Along, FiveAmpere,
                         ::testing::Values(model::Vec3{1, 0, 0}, model::Vec3{0, 1, 0},
                                           model::Vec3{0, 0, -1}),
                         axis_name);

// Noise of the currents must not accumulate over hours in which nothing else changes.
TEST(SteadyCurrent, KeepsTheEstimateRightForHoursWithEachThermistorAndFrontEnd) {
  struct Case {
    device::FrontEndKind front_end;
    int thermistors;
    model::Vec3 held_a;
  };
  for (const Case& one : {Case{device::FrontEndKind::kInLine, 3, {0, 4.5, 0}},
                          Case{device::FrontEndKind::kInLine, 3, {2.6, 2.6, 2.6}},
                          Case{device::FrontEndKind::kInLine, 1, {0, 4.5, 0}},
                          Case{device::FrontEndKind::kDriverCs, 1, {0, 4.5, 0}}}) {
    rig::ThermalBallOptions options;
    options.board.front_end.kind = one.front_end;
    options.board.front_end.thermistors = one.thermistors;
    options.board.ambient_c = options.board.start_c = 25.0;
    rig::ThermalBall ball(options);
    double worst_k = 0.0;
    for (double s = 0.0; s < 2.0 * kDurationS; s += rig::ThermalBall::kStepS) {
      ball.step(one.held_a);
      const double off_k = ball.observer().filter().winding_c(1) - ball.plant().heat().winding_c[1];
      worst_k = std::max(worst_k, std::abs(off_k));
    }
    EXPECT_LT(worst_k, 1.0) << name(one.front_end) << " " << one.thermistors;
    EXPECT_EQ(words(ball.stop()), "none") << name(one.front_end) << " " << one.thermistors;
  }
}

TEST(FifteenAmpere, AreFullForTwentyTwoSecondsFromCold) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    rig::Rig rig;
    rig.run_until_armed();
    model::Vec3 along;
    along[coil] = 1.0;
    const auto effect = rig.start(rig::hold(along, 15.0));
    const model::Tick from = rig.now();
    while (rig.controller().state() == control::State::kArmed && !rig.snapshot().derating &&
           rig.now() - from < 40'000) {
      rig.update(effect, rig::hold(along, 15.0));
      rig.run(10);
    }
    EXPECT_NEAR(static_cast<double>(rig.now() - from) * 1e-3, 22.0, 1.0) << "winding " << coil;
  }
}

}  // namespace
}  // namespace hedgehog::safety

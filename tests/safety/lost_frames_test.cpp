// SPDX-License-Identifier: MIT
// Every second telemetry frame is lost, so that no two are consecutive: every check that needs a
// single frame still works.
#include "daemon/device/simulator/simulator_settings.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;

void run_with_half_the_frames(rig::Rig& rig, model::Tick ticks) {
  for (model::Tick i = 0; i < ticks; i += 2) {
    rig.drop_telemetry(1);
    rig.run(2);
  }
}

struct FaultAmongLostFrames {
  const char* name;
  std::uint16_t sim;
  int coil;
  Reason reason;
};

void PrintTo(const FaultAmongLostFrames& fault, std::ostream* out) { *out << fault.name; }

class EverySecondFrameLost : public ::testing::TestWithParam<FaultAmongLostFrames> {};

TEST_P(EverySecondFrameLost, WrongCurrentsAreMadeSafeAndNamed) {
  const FaultAmongLostFrames& fault = GetParam();
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 5.0));
  run_with_half_the_frames(rig, 500);
  ASSERT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
  ASSERT_NEAR(rig.current_a(), 5.0, 0.1);
  rig.set_faults(fault.sim, fault.coil);
  run_with_half_the_frames(rig, 40);
  expect_tripped(rig, fault.reason);
  run_with_half_the_frames(rig, 25);  // a stuck bridge: the board opens its supply switch
  expect_zero(rig, 0);
}

const FaultAmongLostFrames kFaultsAmongLostFrames[] = {
    {"StuckBridgeIdle", device::kSimStuckBridge, 1, Reason::kUnexpectedCurrent},
    {"OpenWinding", device::kSimOpenWinding, 0, Reason::kCurrentMismatch},
    {"CurrentSense", device::kSimCurrentSense, 0, Reason::kCurrentMismatch},
};

INSTANTIATE_TEST_SUITE_P(Each, EverySecondFrameLost, ::testing::ValuesIn(kFaultsAmongLostFrames),
                         [](const auto& fault) { return fault.param.name; });

TEST(EverySecondFrameLost, AThermistorAtSeventyTrips) {
  rig::RigOptions options;
  options.board.start_c = 71.0;
  rig::Rig rig(options);
  run_with_half_the_frames(rig, 80);
  EXPECT_EQ(name(rig.controller().reason()), "overheated");
}

// Without two consecutive frames no winding temperature can be measured by V/I, so the limits are
// those after a restart.
TEST(EverySecondFrameLost, ADrivenWindingIsLimitedToTheContinuousCurrent) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 12.0));
  rig.run(300);
  ASSERT_NEAR(rig.current_a(), 12.0, 0.1);
  run_with_half_the_frames(rig, 450);
  EXPECT_NEAR(rig.current_a(), 12.0, 0.2);
  run_with_half_the_frames(rig, 100);
  EXPECT_NEAR(rig.current_a(), 5.0, 0.2);
  EXPECT_EQ(name(rig.controller().state()), "armed");
  rig.run(700);
  EXPECT_NEAR(rig.current_a(), 12.0, 0.2) << "measured again";
}

TEST(EverySecondFrameLost, APulseTrainIsLimitedToo) {
  rig::Rig rig;
  rig.run_until_armed();
  for (int i = 0; i < 8; ++i) {
    rig.start(rig::pulse({1, 0, 0}, 12.0, 100));
    run_with_half_the_frames(rig, 600);
  }
  rig.start(rig::pulse({1, 0, 0}, 12.0, 100));
  run_with_half_the_frames(rig, 60);
  EXPECT_NEAR(rig.current_a(), 5.0, 0.2);
}

void run_with_frames_in_pairs(rig::Rig& rig, model::Tick ticks) {
  for (model::Tick i = 0; i < ticks; i += 2) {
    rig.delay_telemetry();
    rig.run(2);
  }
}

// Board and host have independent clocks, so for a while one tick may have no frame and the next
// one two. This has no effect.
TEST(FramesInPairs, DoNotReduceAPush) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 12.0));
  run_with_frames_in_pairs(rig, 2000);
  EXPECT_NEAR(rig.current_a(), 12.0, 0.2);
}

class FaultWithFramesInPairs : public ::testing::TestWithParam<FaultAmongLostFrames> {};

TEST_P(FaultWithFramesInPairs, IsMadeSafeAndNamed) {
  const FaultAmongLostFrames& fault = GetParam();
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 5.0));
  run_with_frames_in_pairs(rig, 500);
  ASSERT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
  rig.set_faults(fault.sim, fault.coil);
  run_with_frames_in_pairs(rig, 40);
  expect_tripped(rig, fault.reason);
  run_with_frames_in_pairs(rig, 25);
  expect_zero(rig, 0);
}

INSTANTIATE_TEST_SUITE_P(Each, FaultWithFramesInPairs, ::testing::ValuesIn(kFaultsAmongLostFrames),
                         [](const auto& fault) { return fault.param.name; });

}  // namespace
}  // namespace hedgehog::safety

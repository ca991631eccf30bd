// SPDX-License-Identifier: MIT
// One part falls silent: a client, io, the whole host, the board, the orientation sensor. For
// control and the link see control_late_test.cpp.
#include "daemon/device/simulator/simulator_settings.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::EndReason;
using control::EventType;
using control::Reason;

TEST(ClientGone, ItsEffectsEndAtTheNextTickAndOthersContinue) {
  rig::Rig rig;
  rig.run_until_armed();
  const auto disconnected = rig.start(rig::hold({1, 0, 0}, 5.0));
  const auto other = rig.start(rig::hold({0, 1, 0}, 4.0));
  rig.run(100);
  rig.stop(disconnected, EndReason::kDisconnected);
  rig.tick();
  EXPECT_FALSE(rig.playing(disconnected));
  ASSERT_NE(rig.last(EventType::kEffectEnded), nullptr);
  EXPECT_EQ(rig.last(EventType::kEffectEnded)->end_reason, EndReason::kDisconnected);
  EXPECT_EQ(rig.snapshot().limited_a.x, 0.0);
  EXPECT_TRUE(rig.playing(other));
  rig.run(kDecay);
  EXPECT_LT(std::abs(rig.plant().current_a().x), kZeroA);
  EXPECT_NEAR(rig.plant().current_a().y, 4.0, 0.05);
}

TEST(ClientSilent, ItsLeaseExpires) {
  rig::Rig rig;
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold({1, 0, 0}, 5.0, 1000));
  rig.run(1000);
  EXPECT_TRUE(rig.playing(effect));
  expect_zero(rig, 2);
  ASSERT_NE(rig.last(EventType::kEffectEnded), nullptr);
  EXPECT_EQ(rig.last(EventType::kEffectEnded)->end_reason, EndReason::kExpired);
}

TEST(IoStuck, EveryEffectEndsByItselfAndStoppingStillWorks) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 5.0, 10'000));
  rig.start(rig::pulse({0, 1, 0}, 5.0, 10'000));
  rig.run(9990);
  EXPECT_GT(rig.current_a(), 4.0);
  expect_zero(rig, 15);
  EXPECT_TRUE(rig.controller().effects_empty());
}

TEST(EmergencyStop, CoilsOffAtTheNextTickDisarmedAndLatched) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 1, 1}, 15.0));
  rig.run(200);
  rig.emergency_stop();
  rig.arm();  // an arming request of the same tick is discarded
  rig.tick();
  EXPECT_FALSE(rig.last_command().enable());
  expect_zero(rig, 0);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(name(rig.snapshot().latch), "emergency_stop");
  ASSERT_NE(rig.last(EventType::kEffectEnded), nullptr);
  EXPECT_EQ(rig.last(EventType::kEffectEnded)->end_reason, EndReason::kTripped);
  rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(100);
  EXPECT_LT(rig.current_a(), kZeroA);
  rig.arm();
  rig.run(20);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(EmergencyStop, OverridesAnArmingOfTheSameTick) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  rig::Rig rig(options);
  rig.run(50);
  rig.arm();
  rig.emergency_stop();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(name(rig.controller().reason()), "emergency_stop");
}

TEST(EmergencyStop, OverridesAnOlderArmingInTheQueue) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  rig::Rig rig(options);
  rig.run(50);
  for (int i = 0; i < control::kMaxCommandsPerTick + 6; ++i) rig.command(control::SetGain{1.0});
  rig.arm();
  rig.emergency_stop();  // handled at the next tick, the arming request one later
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(name(rig.snapshot().latch), "emergency_stop");
  rig.arm();
  rig.run(20);
  EXPECT_EQ(name(rig.controller().state()), "armed") << "one that came after the stop works";
}

TEST(HostFrozen, TheBoardIsSafeAHundredMillisecondsAfterTheLastSetPoint) {
  rig::Rig rig;
  hold_five_ampere(rig);
  rig.freeze_host(99);
  EXPECT_FALSE(asleep(rig));
  rig.freeze_host(1 + 1);
  EXPECT_TRUE(asleep(rig));
  EXPECT_EQ(rig.board().core().outputs().fan, 255);
  rig.freeze_host(kDecay);
  EXPECT_LT(rig.current_a(), kZeroA);
  EXPECT_EQ(rig.board().core().mode(), board::Mode::kLatched);
  // The host resumes: set-points alone do not re-enable the coils.
  rig.run(50);
  EXPECT_LT(rig.current_a(), kZeroA);
  expect_tripped(rig, Reason::kBoardDeadMan);
  rig.arm();
  rig.run(20);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(BoardSilent, AbsentAfterAHundredMillisecondsThenDisarmed) {
  rig::Rig rig;
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(100);
  rig.clear_events();
  rig.set_faults(device::kSimSilent);  // the cable, in both directions
  rig.run(99);
  EXPECT_EQ(name(rig.controller().state()), "armed");
  expect_zero(rig, 5);
  rig.tick();
  EXPECT_EQ(name(rig.controller().state()), "absent");
  EXPECT_EQ(name(rig.controller().reason()), "telemetry_lost");
  EXPECT_FALSE(rig.last_command().enable());
  EXPECT_FALSE(rig.playing(effect));
  EXPECT_EQ(rig.count(EventType::kDeviceDetached), 1);
  EXPECT_EQ(name(rig.snapshot().last_trip.reason), "telemetry_lost");

  rig.set_faults(0);
  rig.run(300);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(name(rig.controller().reason()), "hot_plug");
  EXPECT_EQ(rig.count(EventType::kDeviceAttached), 1);
  EXPECT_LT(rig.current_a(), kZeroA);
  rig.arm();
  rig.run(20);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(BoardSilent, ReconnectedAfterAPullWhileDrivingItStaysDisarmed) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 15.0));
  rig.run(300);
  ASSERT_GT(rig.current_a(), 14.0);
  rig.set_faults(device::kSimSilent);
  rig.run(100 + kDecay);
  EXPECT_EQ(name(rig.controller().state()), "absent");
  EXPECT_LT(rig.current_a(), kZeroA);
  const std::uint64_t lost = rig.link().report().counters.lost;
  // Frame, millisecond and arming counters restart.
  rig.board() = device::SimulatedBoard(device::SimulatedBoardOptions{});
  rig.run(5);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(name(rig.controller().reason()), "hot_plug");
  EXPECT_EQ(rig.link().report().counters.lost, lost);
  rig.start(rig::hold({1, 0, 0}, 15.0));
  rig.run(1000);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(rig.current_a(), 0.0);
  rig.arm();
  rig.run(20);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(BoardSilent, AFewLostFramesAreTolerated) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 8.0));
  for (int i = 0; i < 100; ++i) {
    rig.drop_telemetry(i % 40);
    rig.run(90);
  }
  EXPECT_EQ(name(rig.controller().state()), "armed");
  EXPECT_NEAR(rig.current_a(), 8.0, 0.1);
}

// Its last readings are no measurements of the time after them.
TEST(BoardSilent, ABallThatCoolsMeanwhileIsExpectedToCool) {
  for (const int thermistors : {1, 3}) {
    SCOPED_TRACE(testing::Message() << thermistors << " thermistors");
    rig::RigOptions options;
    options.board.front_end.thermistors = thermistors;
    options.board.start_c = 50.0;
    options.control.start = {{50.0, 50.0, 50.0}, 50.0};
    rig::Rig rig(options);
    rig.run_until_armed();
    rig.run(1000);
    rig.set_faults(device::kSimSilent);
    rig.run_s(600.0);
    for (const double expected_c : rig.controller().thermal().nodes.winding_c) {
      EXPECT_LT(expected_c, 44.0);
      EXPECT_GT(expected_c, rig.plant().hottest_winding_c()) << "whose fan runs";
    }
  }
}

TEST(BoardSilent, ALatchPersistsOverAReconnection) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.set_faults(device::kSimSensorOpen);
  rig.run(100);
  expect_tripped(rig, Reason::kSensorOpen);
  rig.set_faults(device::kSimSilent);
  rig.run(300);
  EXPECT_EQ(name(rig.controller().state()), "absent");
  EXPECT_EQ(name(rig.snapshot().latch), "sensor_open");
  rig.set_faults(0);
  rig.run(300);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  EXPECT_EQ(name(rig.controller().reason()), "sensor_open");
}

TEST(OrientationStale, WorldEffectsFadeInTwoHundredMillisecondsAndEndLost) {
  rig::Rig rig;
  rig.orient({});
  rig.run_until_armed();
  model::EffectSpec spec = rig::hold({1, 0, 0}, 5.0);
  spec.frame = model::Frame::kWorld;
  const auto effect = rig.start(spec);
  rig.run(300);
  ASSERT_NEAR(rig.current_a(), 5.0, 0.05);
  rig.orient({}, false);
  rig.run(100);
  EXPECT_NEAR(rig.current_a(), 5.0, 0.05) << "100 ms old is still fresh";
  EXPECT_EQ(rig.count(EventType::kOrientationLost), 0);
  rig.run(100);
  EXPECT_EQ(rig.count(EventType::kOrientationLost), 1);
  EXPECT_NEAR(rig.current_a(), 2.5, 0.2);
  rig.run(100 + 2 + kDecay);
  EXPECT_LT(rig.current_a(), kZeroA);
  EXPECT_TRUE(rig.playing(effect));
  rig.run(2000);
  EXPECT_FALSE(rig.playing(effect));
  const auto* ended = rig.last(EventType::kEffectEnded);
  ASSERT_NE(ended, nullptr);
  EXPECT_EQ(ended->end_reason, EndReason::kOrientationLost);
  EXPECT_TRUE(asleep(rig));
}

}  // namespace
}  // namespace hedgehog::safety

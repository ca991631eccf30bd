// SPDX-License-Identifier: MIT
// Every fault of the simulated board during an effect: the safe command within the allowed ticks,
// zero current at the plant after 5 L/R, the named latch, one event.
#include <algorithm>

#include "daemon/device/simulator/simulator_settings.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;

struct Fault {
  const char* name;
  std::uint16_t sim;
  int coil;           // index of the faulty winding
  model::Vec3 along;  // direction of the effect
  double current_a;
  Reason reason;
  model::Tick within;  // ticks from the fault to the safe command at the bridge
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

// Two added ticks: one for the telemetry, one for the command.
const Fault kFaults[] = {
    {"SensorOpen", device::kSimSensorOpen, 0, {1, 0, 0}, 5.0, Reason::kSensorOpen, 25 + 2},
    {"SensorShort", device::kSimSensorShort, 0, {1, 0, 0}, 5.0, Reason::kSensorShort, 25 + 2},
    {"SensorJump", device::kSimSensorJump, 0, {0, 1, 0}, 5.0, Reason::kSensorJump, 30 + 2},
    {"SensorStale", device::kSimSensorStale, 0, {1, 0, 0}, 5.0, Reason::kSensorStale, 1010 + 2},
    {"SensorFrozen", device::kSimSensorFrozen, 0, {1, 0, 0}, 10.0, Reason::kSensorFrozen, 12'000},
    {"SensorLoose", device::kSimSensorOffset, 0, {1, 0, 0}, 5.0, Reason::kSensorDisagrees, 32'000},
    {"StuckBridgeIdle", device::kSimStuckBridge, 1, {1, 0, 0}, 5.0, Reason::kUnexpectedCurrent, 18},
    {"StuckBridgeDriven", device::kSimStuckBridge, 0, {1, 0, 0}, 8.0, Reason::kCurrentMismatch, 30},
    {"BridgeFault", device::kSimBridgeFault, 2, {0, 0, 1}, 5.0, Reason::kBridgeFault, 3 + 2},
    {"OpenWinding", device::kSimOpenWinding, 0, {1, 0, 0}, 5.0, Reason::kCurrentMismatch, 15 + 2},
    {"CurrentSense", device::kSimCurrentSense, 0, {1, 0, 0}, 5.0, Reason::kCurrentMismatch, 20 + 2},
    {"SupplyLow", device::kSimSupplyLow, 0, {1, 0, 0}, 3.0, Reason::kBoardSupply, 10 + 2},
};

class HardwareFault : public ::testing::TestWithParam<Fault> {};

TEST_P(HardwareFault, IsMadeSafeAndNamed) {
  const Fault& fault = GetParam();
  rig::Rig rig;
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold(fault.along, fault.current_a));
  rig.run(500);
  ASSERT_NEAR(rig.current_a(), fault.current_a, 0.05);
  ASSERT_EQ(name(rig.controller().state()), "armed");

  rig.set_faults(fault.sim, fault.coil);
  for (model::Tick left = fault.within; left > 0 && !asleep(rig); left -= 5000) {
    rig.update(effect, rig::hold(fault.along, fault.current_a));  // a client that keeps holding
    rig.run_until([&] { return asleep(rig); }, std::min<model::Tick>(left, 5000));
  }
  // A stuck bridge ignores the sleep line: the board's supply switch cuts it off after another 20
  // ms.
  if ((fault.sim & device::kSimStuckBridge) != 0) rig.run(25);
  expect_zero(rig, 0);
  expect_tripped(rig, fault.reason);

  // It stays tripped for any request, and reports it once.
  rig.start(rig::hold(fault.along, fault.current_a));
  rig.run(1500);
  EXPECT_TRUE(asleep(rig));
  EXPECT_LT(rig.current_a(), kZeroA);
  expect_tripped(rig, fault.reason);
  EXPECT_TRUE(rig.controller().effects_empty());
}

TEST_P(HardwareFault, ArmingWorksAgainWhenItIsRepairedAndCool) {
  const Fault& fault = GetParam();
  rig::Rig rig;
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold(fault.along, fault.current_a));
  rig.run(500);
  rig.set_faults(fault.sim, fault.coil);
  for (model::Tick left = fault.within; left > 0; left -= 5000) {
    rig.update(effect, rig::hold(fault.along, fault.current_a));
    rig.run(std::min<model::Tick>(left, 5000));
  }
  rig.run(100);
  ASSERT_EQ(name(rig.controller().state()), "tripped");
  rig.set_faults(0);
  rig.run(5000);
  EXPECT_EQ(name(rig.controller().state()), "tripped") << "never by itself";
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "armed");
  rig.start(rig::hold(fault.along, fault.current_a));
  // wrong currents were integrated as heat; V/I of the windings corrects the estimate
  rig.run(3000);
  EXPECT_NEAR(rig.current_a(), fault.current_a, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Each, HardwareFault, ::testing::ValuesIn(kFaults),
                         [](const auto& fault) { return fault.param.name; });

// A thermistor drifts while no winding carries enough current for a comparison: it is detected only
// when its reading is out of range.
TEST(SensorImpossible, BelowMinusTwentyIsMadeSafeAndNamed) {
  rig::Rig rig;
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold({0, 1, 0}, 1.0));
  rig.set_faults(device::kSimSensorOffset);
  const auto reading_c = [&] { return rig.snapshot().board.sensor_c; };
  while (reading_c() >= -19.0 && rig.now() < 100'000) {
    rig.update(effect, rig::hold({0, 1, 0}, 1.0));
    rig.run(500);
  }
  ASSERT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
  ASSERT_NEAR(rig.current_a(), 1.0, 0.05);
  // From 0.15 K of noise above the limit to as much below, then 40 ms of readings out of range.
  ASSERT_TRUE(rig.run_until([&] { return reading_c() < -20.0; }, 2500));
  expect_zero(rig, 1200);
  expect_tripped(rig, Reason::kSensorImplausible);
}

TEST(FanFault, NoTachometerForThreeSecondsTrips) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.set_faults(device::kSimFanStopped);
  const auto effect = rig.start(rig::hold({1, 0, 0}, 10.0));
  rig.run(5000);
  rig.update(effect, rig::hold({1, 0, 0}, 10.0));
  ASSERT_TRUE(rig.run_until([&] { return rig.last_command().fan == 255; }, 10'000));
  ASSERT_EQ(name(rig.controller().state()), "armed");
  rig.update(effect, rig::hold({1, 0, 0}, 5.0));
  rig.run(2900);
  EXPECT_EQ(name(rig.controller().state()), "armed");
  expect_zero(rig, 100 + 4);
  expect_tripped(rig, Reason::kFanStopped);

  // Fan still stopped: arming is rejected. Repaired: it turns, and arming succeeds.
  rig.run(1000);
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "fan_stopped");
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  rig.set_faults(0);
  rig.run(1000);
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(FanFault, BlocksTheFirstArming) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  options.board.start_c = 45.0;  // so that the fan is required
  rig::Rig rig(options);
  rig.set_faults(device::kSimFanStopped);
  rig.run(2900);
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "none") << "a fan may take its time to start";
  rig.run(200);
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "fan_stopped");
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  rig.set_faults(0);
  rig.run(1000);
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(UnexpectedCurrent, TripsWithoutAnyRequest) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.run(50);
  rig.set_faults(device::kSimStuckBridge, 2);
  ASSERT_TRUE(
      rig.run_until([&] { return rig.controller().state() == control::State::kTripped; }, 15 + 3));
  expect_tripped(rig, Reason::kUnexpectedCurrent);
  rig.run(25 + kDecay);  // the board opens its supply switch
  EXPECT_LT(rig.current_a(), kZeroA);
  // While the bridge is stuck, the board rejects arming.
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
}

TEST(Arming, ABoardThatKeepsItsLatchIsATripAndReportedAsOne) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  rig::Rig rig(options);
  rig.run(100);
  rig.set_faults(device::kSimSupplyLow);
  rig.run(100);
  ASSERT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(rig.snapshot().last_trip.reason, Reason::kNone);
  rig.clear_events();
  rig.arm();
  rig.run(400);
  expect_tripped(rig, Reason::kBoardSupply);
  const auto& events = rig.events();
  EXPECT_EQ(
      std::count_if(events.begin(), events.end(), [](const auto& event) { return event.trip; }), 1);
  EXPECT_LT(rig.current_a(), kZeroA);
}

TEST(UnexpectedCurrent, TripsWhileDisarmedToo) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  rig::Rig rig(options);
  rig.run(100);
  ASSERT_EQ(name(rig.controller().state()), "disarmed");
  rig.set_faults(device::kSimStuckBridge, 0);
  rig.run(60);
  EXPECT_LT(rig.current_a(), kZeroA);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
}

}  // namespace
}  // namespace hedgehog::safety

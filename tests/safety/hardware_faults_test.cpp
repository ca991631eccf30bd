// SPDX-License-Identifier: MIT
// Every fault of the simulated board during an effect: the safe command within the allowed ticks,
// zero current at the plant after 5 L/R, the named latch, one event.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

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

/// A fault on one of the windings, of a ball that is cold or warm.
struct FaultCase {
  Fault fault;
  device::FrontEndKind front_end;
  double start_c;
};

void PrintTo(const FaultCase& one, std::ostream* out) {
  *out << one.fault.name << " of "
       << "xyz"[one.fault.coil] << ", " << device::name(one.front_end) << ", from " << one.start_c
       << " C";
}

/// With other windings in the same order.
Fault turned(Fault fault, int by) {
  model::Vec3 along;
  for (int coil = 0; coil < model::kCoils; ++coil)
    along[(coil + by) % model::kCoils] = fault.along[coil];
  fault.along = along;
  fault.coil = (fault.coil + by) % model::kCoils;
  return fault;
}

/// `fault` on the windings that are `by` further, and what is reported there.
FaultCase fault_case(Fault fault, device::FrontEndKind front_end, int by, double start_c) {
  const bool in_line = front_end == device::FrontEndKind::kInLine;
  // Only the device file's thermistor has reasons of its own; those of other windings contradict
  // their V/I.
  const bool by_comparison = fault.reason == Reason::kSensorJump ||
                             fault.reason == Reason::kSensorFrozen ||
                             fault.reason == Reason::kSensorDisagrees;
  if (by > 0 && by_comparison) fault.reason = Reason::kMeasurementsDisagree;
  // CS does not measure a bridge whose zero is drawn so low that it seems to be opposed.
  if (!in_line && fault.sim == device::kSimOpenWinding) fault.within = 30;
  return {turned(fault, by), front_end, start_c};
}

std::vector<FaultCase> fault_cases() {
  std::vector<FaultCase> cases;
  for (const Fault& fault : kFaults)
    for (const double start_c : {25.0, 44.0})
      for (int by = 0; by < model::kCoils; ++by) {
        cases.push_back(fault_case(fault, device::FrontEndKind::kInLine, by, start_c));
        const bool thermistor = std::string_view(fault.name).starts_with("Sensor");
        if (by == 0 || !thermistor)
          cases.push_back(fault_case(fault, device::FrontEndKind::kDriverCs, by, start_c));
      }
  return cases;
}

class HardwareFault : public ::testing::TestWithParam<FaultCase> {
 protected:
  static rig::RigOptions options() {
    rig::RigOptions options;
    options.board.front_end.kind = GetParam().front_end;
    options.board.start_c = GetParam().start_c;
    options.control.start.winding_c.fill(GetParam().start_c);
    options.control.start.core_c = GetParam().start_c;
    return options;
  }
  const Fault& fault = GetParam().fault;
  rig::Rig rig{options()};
};

TEST_P(HardwareFault, IsMadeSafeAndNamed) {
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
  if (fault.reason == Reason::kMeasurementsDisagree) {
    const control::Disagreement found = rig.controller().last_trip().disagreement;
    EXPECT_EQ(found.coil(), fault.coil);
    EXPECT_TRUE(found.has(control::Quantity::kThermistor));
    EXPECT_EQ(found.has(control::Quantity::kResistance), fault.sim != device::kSimSensorJump);
  }

  // It stays tripped for any request, and reports it once.
  rig.start(rig::hold(fault.along, fault.current_a));
  rig.run(1500);
  EXPECT_TRUE(asleep(rig));
  EXPECT_LT(rig.current_a(), kZeroA);
  expect_tripped(rig, fault.reason);
  EXPECT_TRUE(rig.controller().effects_empty());
}

TEST_P(HardwareFault, ArmingWorksAgainWhenItIsRepairedAndCool) {
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

INSTANTIATE_TEST_SUITE_P(Each, HardwareFault, ::testing::ValuesIn(fault_cases()),
                         [](const auto& made) {
                           const FaultCase& one = made.param;
                           return std::string(one.fault.name) + "_" + "xyz"[one.fault.coil] + "_" +
                                  std::string(device::name(one.front_end)) +
                                  (one.start_c > 40.0 ? "_warm" : "_cold");
                         });

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

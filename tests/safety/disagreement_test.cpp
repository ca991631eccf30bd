// SPDX-License-Identifier: MIT
// A measurement fails while a winding is driven hard: detected by contradicting measurements,
// before any part overheats. On the whole rig, with the firmware's own conversion of raw values.
#include <tuple>

#include "tests/rig/fault_run.h"
#include "tests/rig/thermal_ball.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Quantity;
using control::Reason;
using device::SimulatorErrorKind;

struct Wrong {
  SimulatorErrorKind kind;
  double value;
  double ramp_s;
  /// The quantities reported as the possible cause include this one.
  Quantity named;
};

std::ostream& operator<<(std::ostream& out, const Wrong& wrong) {
  return out << name(wrong.kind) << " " << wrong.value << " over " << wrong.ramp_s << " s";
}

class EachWrong : public ::testing::TestWithParam<std::tuple<Wrong, int, int>> {
 protected:
  EachWrong() {
    rig::RigOptions options;
    options.board.front_end.thermistors = std::get<2>(GetParam());
    rig = std::make_unique<rig::Rig>(options);
  }
  /// Holds 12 A until `celsius`, then injects `wrong` and continues until the ball stops.
  void drive(double celsius, const Wrong& wrong, int coil) {
    rig->run_until_armed();
    model::Vec3 along;
    along[coil] = 1.0;
    const auto effect = rig->start(rig::hold(along, 12.0));
    bool broken = false;
    for (int second = 0; second < 150; ++second) {
      rig->update(effect, rig::hold(along, 12.0));
      for (int i = 0; i < 1000; ++i) {
        rig->tick();
        hottest_c = std::max(hottest_c, rig->plant().hottest_winding_c());
      }
      if (rig->controller().state() != control::State::kArmed) return;
      if (broken || rig->plant().hottest_winding_c() < celsius) continue;
      broken = true;
      device::SimulatorErrorList errors;
      errors.generation = 1;
      errors.error[errors.count++] = {wrong.kind, static_cast<std::uint8_t>(coil), wrong.value,
                                      wrong.ramp_s};
      rig->board().set_errors(errors);
    }
  }
  std::unique_ptr<rig::Rig> rig;
  double hottest_c = 0.0;
};

TEST_P(EachWrong, IsNamedAndStopsTheBallBeforeAnythingIsTooWarm) {
  const auto& [wrong, coil, thermistors] = GetParam();
  drive(45.0, wrong, coil);
  EXPECT_LT(hottest_c, 75.0);
  expect_tripped(*rig, Reason::kMeasurementsDisagree);
  expect_zero(*rig, 2);
  const control::Disagreement found = rig->controller().last_trip().disagreement;
  EXPECT_TRUE(found.has(wrong.named)) << words(rig::Stop{rig->controller().reason(), found});
  EXPECT_EQ(found.coil(), coil);
}

INSTANTIATE_TEST_SUITE_P(
    Sudden, EachWrong,
    ::testing::Combine(
        ::testing::Values(
            Wrong{SimulatorErrorKind::kResistanceGain, 0.9, 0.0, Quantity::kResistance},
            Wrong{SimulatorErrorKind::kShortedTurns, 0.1, 0.0, Quantity::kResistance},
            Wrong{SimulatorErrorKind::kCurrentGain, 1.1, 0.0, Quantity::kCurrent},
            Wrong{SimulatorErrorKind::kCurrentOffsetA, 1.0, 0.0, Quantity::kCurrent},
            Wrong{SimulatorErrorKind::kSupplyGain, 0.9, 0.0, Quantity::kSupplyVoltage}),
        ::testing::Values(0, 1, 2), ::testing::Values(1, 3)));

INSTANTIATE_TEST_SUITE_P(
    Growing, EachWrong,
    ::testing::Combine(::testing::Values(Wrong{SimulatorErrorKind::kShortedTurns, 0.2, 60.0,
                                               Quantity::kResistance},
                                         Wrong{SimulatorErrorKind::kCurrentGain, 1.2, 60.0,
                                               Quantity::kCurrent},
                                         Wrong{SimulatorErrorKind::kSupplyGain, 0.85, 60.0,
                                               Quantity::kSupplyVoltage}),
                       ::testing::Values(0, 1, 2), ::testing::Values(1, 3)));

/// A rise: a fall of V/I trips within two windows of the filter, before they have rejected it.
using ARejectedReading = EachWrong;

TEST_P(ARejectedReading, IsAnEventBeforeTheTrip) {
  const auto& [wrong, coil, thermistors] = GetParam();
  drive(45.0, wrong, coil);
  expect_tripped(*rig, Reason::kMeasurementsDisagree);
  expect_zero(*rig, 2);
  const control::Event* rejected = rig->last(control::EventType::kMeasurementRejected);
  ASSERT_NE(rejected, nullptr);
  EXPECT_EQ(rejected->disagreement,
            control::Disagreement(coil, wrong.named, Quantity::kHeatBalance));
  EXPECT_LT(rejected->tick, rig->controller().last_trip().tick);
}

INSTANTIATE_TEST_SUITE_P(Sudden, ARejectedReading,
                         ::testing::Combine(::testing::Values(Wrong{
                                                SimulatorErrorKind::kResistanceGain, 1.05, 0.0,
                                                Quantity::kResistance}),
                                            ::testing::Values(0, 1, 2), ::testing::Values(1, 3)));

TEST(RejectedReading, OfABallThatIsReplacedIsReportedOnceAndNotAsAccepted) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({0, 1, 0}, 8.0));
  rig.run_s(3.0);
  device::SimulatorErrorList errors;
  errors.generation = 1;
  errors.error[errors.count++] = {SimulatorErrorKind::kResistanceGain, 1, 1.05, 0.0};
  rig.board().set_errors(errors);
  ASSERT_TRUE(
      rig.run_until([&] { return rig.count(control::EventType::kMeasurementRejected) > 0; }, 1000));
  rig.command(control::ResetBall{});
  rig.run_s(5.0);
  EXPECT_EQ(rig.count(control::EventType::kMeasurementAccepted), 0);
  EXPECT_EQ(rig.count(control::EventType::kMeasurementRejected), 1);
}

// V/I leaves its gate after the filter has taken a part of the change for a drift of R25: both
// together are what the supply's voltage explains.
TEST(SlowlyFallingSupplyReading, IsNamedAlthoughAPartOfItWasTakenForADrift) {
  for (const int winding : {1, 2}) {
    rig::ThermalFault fault;
    fault.error = {SimulatorErrorKind::kSupplyGain, static_cast<std::uint8_t>(winding), 0.97,
                   120.0};
    fault.from_c = 45.0;
    fault.winding = winding;
    const rig::FaultResult result = rig::run_fault(fault, rig::matching_ball(fault, {}));
    EXPECT_EQ(result.stop.reason, Reason::kMeasurementsDisagree);
    EXPECT_TRUE(result.stop.disagreement.has(Quantity::kSupplyVoltage)) << words(result.stop);
    EXPECT_LT(result.hottest_c, 75.0);
  }
}

/// Trips within 50 ms at 70 C by V/I, which is less than the contradictions' hold times.
using AReadingThatSimulatesHeat = EachWrong;

TEST_P(AReadingThatSimulatesHeat, StopsTheBallAndIsNamed) {
  const auto& [wrong, coil, thermistors] = GetParam();
  drive(55.0, wrong, coil);
  expect_tripped(*rig, Reason::kOverheated);
  expect_zero(*rig, 2);
  const control::Disagreement found = rig->controller().last_trip().disagreement;
  EXPECT_TRUE(found.has(wrong.named)) << words(rig::Stop{rig->controller().reason(), found});
  EXPECT_EQ(found.coil(), coil);
  const control::Event* tripped = rig->last(control::EventType::kStateChanged);
  ASSERT_NE(tripped, nullptr);
  EXPECT_EQ(tripped->disagreement, found);
}

INSTANTIATE_TEST_SUITE_P(
    Sudden, AReadingThatSimulatesHeat,
    ::testing::Combine(::testing::Values(Wrong{SimulatorErrorKind::kResistanceGain, 1.15, 0.0,
                                               Quantity::kResistance},
                                         Wrong{SimulatorErrorKind::kCurrentGain, 0.8, 0.0,
                                               Quantity::kCurrent},
                                         Wrong{SimulatorErrorKind::kSupplyGain, 1.1, 0.0,
                                               Quantity::kSupplyVoltage}),
                       ::testing::Values(0, 1, 2), ::testing::Values(1, 3)));

}  // namespace
}  // namespace hedgehog::safety

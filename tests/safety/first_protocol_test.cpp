// SPDX-License-Identifier: MIT
// A board of protocol 1.0 in closed loop: it does not report what it measures, so currents are
// valid while their winding is driven; one thermistor, no supply current.
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using device::SimulatorErrorKind;

class FirstProtocol : public ::testing::Test {
 protected:
  static rig::RigOptions options() {
    rig::RigOptions options;
    options.board.front_end.kind = device::FrontEndKind::kDriverCs;
    options.first_protocol = true;
    return options;
  }
  void SetUp() override { rig.run_until_armed(); }
  void set_error(SimulatorErrorKind kind, int coil, double value) {
    device::SimulatorErrorList errors;
    errors.generation = 1;
    errors.error[errors.count++] = {kind, static_cast<std::uint8_t>(coil), value, 0.0};
    rig.board().set_errors(errors);
  }
  bool armed() const { return rig.controller().state() == control::State::kArmed; }
  /// Holds `current_a` along winding `coil` for `seconds`, or until the ball stops.
  void play(int coil, double current_a, int seconds) {
    model::Vec3 along;
    along[coil] = 1.0;
    const auto effect = rig.start(rig::hold(along, current_a));
    for (int second = 0; second < seconds && armed(); ++second) {
      rig.update(effect, rig::hold(along, current_a));
      for (int i = 0; i < 1000; ++i) {
        rig.tick();
        hottest_c = std::max(hottest_c, rig.plant().hottest_winding_c());
      }
    }
    rig.stop(effect);
  }
  rig::Rig rig{options()};
  double hottest_c = 0.0;
};

TEST_F(FirstProtocol, HasTheFewestMeasurements) {
  rig.run(10);
  const device::BoardTelemetry& telemetry = rig.link().report().telemetry;
  EXPECT_EQ(telemetry.protocol_minor, 0);
  EXPECT_EQ(telemetry.thermistors, 1);
  EXPECT_FALSE(telemetry.supply_current_known);
}

TEST_F(FirstProtocol, AHealthyBallPlaysAlongEachWindingWithoutATrip) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    play(coil, 5.0, 20);
    play(coil, -8.0, 10);
    ASSERT_TRUE(armed()) << coil << ": " << name(rig.controller().reason());
  }
}

TEST_F(FirstProtocol, FullDemandIsReducedByTheLimiterNotByATrip) {
  play(1, 15.0, 90);
  EXPECT_TRUE(armed()) << name(rig.controller().reason());
  EXPECT_LT(hottest_c, 70.0);
  EXPECT_LT(rig.controller().passed().a()[1], 15.0);
}

TEST_F(FirstProtocol, AStuckLineIsMadeSafeWithinThirtyMilliseconds) {
  rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(100);
  set_error(SimulatorErrorKind::kPwmStuck, 1, 0.3);
  expect_zero(rig, 30);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
}

struct FirstProtocolWinding : FirstProtocol, testing::WithParamInterface<int> {};

TEST_P(FirstProtocolWinding, TurnsThatShortStopTheBall) {
  play(GetParam(), 10.0, 15);
  set_error(SimulatorErrorKind::kShortedTurns, GetParam(), 0.2);
  play(GetParam(), 10.0, 60);
  EXPECT_LT(hottest_c, 75.0);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  EXPECT_LT(rig.current_a(), kZeroA);
}

INSTANTIATE_TEST_SUITE_P(Each, FirstProtocolWinding, testing::Values(0, 1, 2));

TEST_F(FirstProtocol, ASilentBoardIsAbsentAndSafe) {
  rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(100);
  rig.drop_telemetry(1000);
  rig.run(200);
  EXPECT_EQ(name(rig.controller().state()), "absent");
  EXPECT_EQ(name(rig.controller().reason()), "telemetry_lost");
  rig.run(kDecay);
  EXPECT_LT(rig.current_a(), kZeroA);
}

}  // namespace
}  // namespace hedgehog::safety

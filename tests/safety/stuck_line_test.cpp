// SPDX-License-Identifier: MIT
// A stuck PWM line: its bridge drives regardless of commands while it is awake. On each front end,
// with the firmware's own conversion of raw values.
#include <array>
#include <tuple>

#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using device::FrontEndKind;

constexpr model::Tick kStuckWithin = 30;

void stick(rig::Rig& rig, int coil, double duty) {
  device::SimulatorErrorList errors;
  errors.error[errors.count++] = {device::SimulatorErrorKind::kPwmStuck,
                                  static_cast<std::uint8_t>(coil), duty, 0.0};
  rig.board().set_errors(errors);
}

rig::RigOptions with(FrontEndKind kind) {
  rig::RigOptions options;
  options.board.front_end.kind = kind;
  return options;
}

using StuckLineCase = std::tuple<FrontEndKind, double>;
class StuckLine : public ::testing::TestWithParam<StuckLineCase> {
 protected:
  rig::Rig rig{with(std::get<0>(GetParam()))};
  double duty = std::get<1>(GetParam());
};

TEST_P(StuckLine, OfAnIdleWindingIsMadeSafeWithinThirtyMilliseconds) {
  hold_five_ampere(rig);
  stick(rig, 1, duty);
  expect_zero(rig, kStuckWithin);
  expect_tripped(rig, control::Reason::kUnexpectedCurrent);
}

// The effect ends while another one continues, so that the bridges stay awake.
TEST_P(StuckLine, OfAWindingThatShouldBeIdleNowIsMadeSafeWithinThirtyMilliseconds) {
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 5.0));
  const auto other = rig.start(rig::hold({0, 1, 0}, 12.0));
  rig.run(200);
  ASSERT_EQ(name(rig.controller().state()), "armed");
  stick(rig, 1, duty);
  rig.stop(other);
  expect_zero(rig, kStuckWithin);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
}

// Without effects the bridges sleep, and the line can drive nothing until they wake.
TEST_P(StuckLine, DrivesNothingWhileTheBridgesSleep) {
  rig.run_until_armed();
  stick(rig, 2, duty);
  rig.run(500);
  EXPECT_LT(rig.current_a(), kZeroA);
  rig.start(rig::hold({1, 0, 0}, 5.0));
  ASSERT_TRUE(rig.run_until([&] { return !asleep(rig); }, 5));
  expect_zero(rig, kStuckWithin);
  expect_tripped(rig, control::Reason::kUnexpectedCurrent);
}

// The line is repaired: arming once is enough, whatever the front end measures while bridges sleep.
TEST_P(StuckLine, CanBeArmedAgainWhenItIsRepaired) {
  hold_five_ampere(rig);
  stick(rig, 1, duty);
  expect_zero(rig, kStuckWithin);
  rig.board().set_errors({});
  rig.run(200);
  rig.arm();
  rig.run(100);
  EXPECT_EQ(name(rig.controller().state()), "armed") << name(rig.snapshot().arming_blocker);
}

std::string name_of(const ::testing::TestParamInfo<StuckLineCase>& info) {
  std::string text(device::name(std::get<0>(info.param)));
  const double duty = std::get<1>(info.param);
  return text + (duty < 0.0 ? "_minus_" : "_") +
         std::to_string(std::lround(100.0 * std::abs(duty)));
}

INSTANTIATE_TEST_SUITE_P(FrontEnds, StuckLine,
                         ::testing::Combine(::testing::Values(FrontEndKind::kInLine,
                                                              FrontEndKind::kDriverCs,
                                                              FrontEndKind::kIdeal),
                                            ::testing::Values(0.1, 0.3, 0.5, 1.0, -0.3)),
                         name_of);

// The board alone, without any detection by the host.
TEST(StuckLineAlone, IsMadeSafeByTheBoard) {
  for (const FrontEndKind kind : {FrontEndKind::kInLine, FrontEndKind::kDriverCs}) {
    rig::Rig rig(with(kind));
    hold_five_ampere(rig);
    stick(rig, 1, 0.3);
    rig.drop_telemetry(1000);
    EXPECT_TRUE(rig.run_until([&] { return asleep(rig); }, kStuckWithin));
    EXPECT_NE(rig.board().core().faults() & board::kUnexpectedCurrent, 0);
  }
}

}  // namespace
}  // namespace hedgehog::safety

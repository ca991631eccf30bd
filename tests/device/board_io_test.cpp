// SPDX-License-Identifier: MIT
#include "daemon/device/board_io.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/device/limited.h"

namespace hedgehog::device {
namespace {

constexpr double kInductance = 1.5e-3;
constexpr double kDutyStep = 1.0 / 32767.0;

TEST(BoardCommandDrive, HoldsACurrentByItsResistance) {
  const BoardCommand command =
      BoardCommand::drive(limited({5, 0, -3}), kColdOhm, kInductance, {5, 0, -3}, 12.0);
  EXPECT_TRUE(command.enable());
  EXPECT_NEAR(command.duty().x, 5 * 0.45 / 12, kDutyStep);
  EXPECT_EQ(command.duty().y, 0.0);
  EXPECT_NEAR(command.duty().z, -3 * 0.45 / 12, kDutyStep);
}

TEST(BoardCommandDrive, ACurrentThatFlowsNeedsNoBoost) {
  const BoardCommand command =
      BoardCommand::drive(limited({5, 0, -3}), kColdOhm, kInductance, {5, 0, -3}, 12.0);
  for (const std::int16_t boost : command.boost_q15()) EXPECT_EQ(boost, 0);
  EXPECT_EQ(command.first_duty(), command.duty());
}

TEST(BoardCommandDrive, TheFirstMillisecondArrivesAtTheCurrentExactly) {
  const std::array<double, model::kCoils> ohm{0.40, 0.45, 0.55};
  const model::Vec3 requested{2, -4, 3};
  const model::Vec3 now{1, -1, 8};
  const BoardCommand command = BoardCommand::drive(limited(requested), ohm, kInductance, now, 12.0);
  for (int k = 0; k < model::kCoils; ++k) {
    const double r = ohm[static_cast<std::size_t>(k)];
    const double settled = 12.0 * command.first_duty()[k] / r;
    const double after = settled + (now[k] - settled) * std::exp(-r * 1e-3 / kInductance);
    EXPECT_NEAR(after, requested[k], 1e-3) << k;
    EXPECT_NEAR(12.0 * command.duty()[k] / r, requested[k], 1e-3) << "and stays there";
  }
}

TEST(BoardCommandDrive, StaysWithinTheSupply) {
  const BoardCommand command =
      BoardCommand::drive(limited({15, 0, 0}), kColdOhm, kInductance, {-15, 15, 0}, 12.0);
  EXPECT_EQ(command.first_duty().x, 1.0);
  EXPECT_EQ(command.first_duty().y, -1.0);
  EXPECT_NEAR(command.duty().x, 15 * 0.45 / 12, kDutyStep) << "what is held stays what was asked";
  EXPECT_EQ(command.duty().y, 0.0);
  const BoardCommand weak =
      BoardCommand::drive(limited({15, -15, 0}), {1.2, 1.2, 1.2}, kInductance, {-40, 40, 0}, 12.0);
  EXPECT_EQ(weak.duty_q15()[0], 32767);
  EXPECT_EQ(weak.first_duty().x, 1.0);
  EXPECT_EQ(weak.first_duty().y, -1.0);
}

TEST(BoardCommandDrive, ARepeatedOneIsTheSameWithoutTheBoost) {
  BoardCommand command =
      BoardCommand::drive(limited({8, 0, 0}), kColdOhm, kInductance, {0, 0, 0}, 12.0);
  command.fan = 7;
  command.arm_count = 3;
  ASSERT_GT(command.boost_q15()[0], 0);
  const BoardCommand held = command.held();
  EXPECT_TRUE(held.enable());
  EXPECT_EQ(held.duty_q15(), command.duty_q15());
  EXPECT_EQ(held.first_duty(), command.duty());
  EXPECT_EQ(held.fan, 7);
  EXPECT_EQ(held.arm_count, 3);
}

TEST(BoardCommandDrive, IsSafeForAnyInvalidNumber) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const model::LimitedCurrents currents = limited({5, 5, 5});
  const model::Vec3 now{5, 5, 5};
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_FALSE(BoardCommand::drive(currents, {0.45, bad, 0.45}, kInductance, now, 12).enable());
    EXPECT_FALSE(BoardCommand::drive(currents, kColdOhm, bad, {0, 0, 0}, 12).enable());
    EXPECT_FALSE(BoardCommand::drive(currents, kColdOhm, kInductance, {0, 0, bad}, 12).enable());
    EXPECT_FALSE(BoardCommand::drive(currents, kColdOhm, kInductance, now, bad).enable());
  }
  EXPECT_FALSE(BoardCommand::drive(currents, kColdOhm, kInductance, now, 0.0).enable());
  EXPECT_FALSE(BoardCommand::drive(currents, kColdOhm, kInductance, now, -12.0).enable());
  const BoardCommand safe = BoardCommand::drive(currents, kColdOhm, kNan, now, 12);
  EXPECT_EQ(safe.duty(), (model::Vec3{0, 0, 0}));
  EXPECT_EQ(safe.first_duty(), (model::Vec3{0, 0, 0}));
  EXPECT_FALSE(BoardCommand::drive(currents, {0.45, 0.0, 0.45}, kInductance, now, 12).enable());
}

}  // namespace
}  // namespace hedgehog::device

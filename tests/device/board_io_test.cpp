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

TEST(BoardCommandDrive, FeedsTheInductanceForward) {
  const BoardCommand command =
      BoardCommand::drive(limited({2, 0, 0}), kColdOhm, kInductance, {1, 0, 0}, 12.0);
  EXPECT_NEAR(command.duty().x, (2 * 0.45 + 1.5e-3 * 1 / 1e-3) / 12, kDutyStep);
}

TEST(BoardCommandDrive, StaysWithinTheSupply) {
  const BoardCommand command =
      BoardCommand::drive(limited({15, 0, 0}), kColdOhm, kInductance, {-15, 15, 0}, 12.0);
  EXPECT_EQ(command.duty_q15()[0], 32767);
  EXPECT_EQ(command.duty_q15()[1], -32767);
}

TEST(BoardCommandDrive, IsSafeOnAnyNumberThatIsNone) {
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
}

}  // namespace
}  // namespace hedgehog::device

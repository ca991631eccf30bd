// SPDX-License-Identifier: MIT
// The leaky sum of the board's I^2 t, bit-exact.
#include "daemon/device/board_core/heat_budget.h"

#include <gtest/gtest.h>

namespace hedgehog::board {
namespace {

// 1 A^2 s in one millisecond.
constexpr std::uint32_t kUnit = 1'000'000'000u;
// A sum whose leak is less than one bit.
constexpr int kNoLeak = 60;

TEST(BoardHeatBudget, IsSpentWhenItIsReached) {
  HeatBudget budget(kNoLeak);
  for (int i = 0; i < 3; ++i) budget.step(kUnit);
  EXPECT_FALSE(HeatBudget(budget).exceeded(4));
  budget.step(kUnit - 1);
  EXPECT_FALSE(HeatBudget(budget).exceeded(4));
  budget.step(1);
  EXPECT_TRUE(budget.exceeded(4));
}

TEST(BoardHeatBudget, StaysSpentUntilSevenEighths) {
  HeatBudget spent(1);
  for (int i = 0; i < 3; ++i) spent.step(2 * kUnit);  // 2, 3 and 3.5
  EXPECT_FALSE(HeatBudget(spent).exceeded(4)) << "not spent before";
  HeatBudget latched = spent;
  EXPECT_TRUE(latched.exceeded(3));
  EXPECT_TRUE(latched.exceeded(4)) << "3.5 is 7/8 of 4";
  HeatBudget less = spent;
  EXPECT_TRUE(less.exceeded(3));
  less.step(kUnit * 7 / 4 - 1);  // 3.5 minus one mA^2 ms
  EXPECT_FALSE(less.exceeded(4));
  EXPECT_FALSE(less.exceeded(4)) << "cool again";
}

TEST(BoardHeatBudget, LosesItsShareEachMillisecond) {
  HeatBudget budget(2);
  budget.step(4 * kUnit);
  budget.step(0);
  EXPECT_EQ(budget.permille(4), 750);
  budget.step(kUnit);
  EXPECT_EQ(budget.permille(4), 812) << "(3 - 3/4 + 1) / 4";
}

TEST(BoardHeatBudget, IsReportedInThousandthsAndSaturates) {
  HeatBudget budget(kNoLeak);
  for (int i = 0; i < 65; ++i) budget.step(kUnit);
  budget.step(kUnit / 1000 * 534);
  EXPECT_EQ(budget.permille(1), 65534);
  budget.step(kUnit / 1000);
  EXPECT_EQ(budget.permille(1), 65535);
  budget.step(kUnit / 1000);
  EXPECT_EQ(budget.permille(1), 65535);
  EXPECT_EQ(budget.permille(1000), 65);
  EXPECT_EQ(budget.permille(0), 65535) << "nothing is allowed";
  EXPECT_EQ(HeatBudget(kNoLeak).permille(0), 65535);
}

}  // namespace
}  // namespace hedgehog::board

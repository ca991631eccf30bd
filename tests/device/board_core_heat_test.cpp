// SPDX-License-Identifier: MIT
// The board's I^2 t: does not restrict what the limiter allows, and ends what exceeds it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/limit/thermal_limiter.h"
#include "model/thermal/plant.h"
#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

constexpr int kHour = 3'600'000;

// Milliseconds of `current_ma` in each of `windings` until the budget is spent; -1: not within 90
// minutes.
int budget_ms(std::int16_t current_ma, int windings) {
  HeatBudget winding(kWindingTauShift);
  HeatBudget device(kDeviceTauShift);
  const auto squared = static_cast<std::uint32_t>(current_ma * current_ma);
  const BoardLimits limits;
  for (int ms = 1; ms <= kHour * 3 / 2; ++ms) {
    winding.step(squared);
    device.step(squared * static_cast<std::uint32_t>(windings));
    if (winding.exceeded(limits.winding_a2s) || device.exceeded(limits.device_a2s)) return ms;
  }
  return -1;
}

TEST(BoardHeat, FiveAmperesAreAllowedForEver) { EXPECT_EQ(budget_ms(5000, 1), -1); }

TEST(BoardHeat, FifteenAmperesAlongOneWindingEndAfter52Seconds) {
  // -tau ln(1 - Q / (225 tau)) with tau = 131.072 s and Q = 9640 A^2 s.
  EXPECT_NEAR(budget_ms(15000, 1), 51900, 150);
}

TEST(BoardHeat, EightAmperesInEachOfThreeWindingsEndByTheSumOfTheDevice) {
  const double tau_s = 524.288;
  const double squared = 3.0 * 64.0;
  const double expected_ms = -1000.0 * tau_s * std::log(1.0 - 30700.0 / (squared * tau_s));
  EXPECT_NEAR(budget_ms(8000, 3), expected_ms, 500);
}

TEST(BoardHeat, LatchesTheCoreAndCoolsDownBeforeItCanBeArmed) {
  CoreBench bench;
  bench.set_point.duty_q15[2] = 20'000;
  bench.arm_and_drive();
  bench.inputs.current_ma[2] = 15000;
  int ms = 0;
  for (; ms < 60'000 && bench.drives(); ++ms) bench.run(1);
  EXPECT_TRUE(bench.latched_by(kHeatBudget));
  EXPECT_NEAR(ms, 51900, 150);
  EXPECT_GE(bench.telemetry().winding_heat_permille, 1000);

  bench.inputs.current_ma[2] = 0;
  bench.run(1000);
  bench.arm_and_drive();
  EXPECT_TRUE(bench.latched_by(kHeatBudget)) << "just below the budget is not cool";
  // 7/8 of the budget is reached after tau ln(8/7) = 17.5 s.
  bench.run(17'000);
  bench.arm_and_drive();
  EXPECT_TRUE(bench.drives());
}

// Largest used share of a budget at maximum demand along the windings, limited by the law alone.
double fullest_budget(const model::Vec3& shares, double stronger, double ambient_c) {
  model::PlantParameters parameters;
  for (std::size_t k = 0; k < 3; ++k) {
    parameters.winding_j_k[k] *= stronger;
    parameters.winding_to_core_k_w[k] /= stronger;
  }
  parameters.core_j_k *= stronger;
  parameters.core_to_ambient_fan_k_w /= stronger;
  model::Plant plant(parameters, ambient_c);
  const model::Limits limits;
  HeatBudget winding[3] = {HeatBudget(kWindingTauShift), HeatBudget(kWindingTauShift),
                           HeatBudget(kWindingTauShift)};
  HeatBudget device(kDeviceTauShift);
  const BoardLimits board;
  std::uint16_t max_share = 0;
  for (int step = 0; step < kHour * 3 / 2 / 100; ++step) {
    const double allowed =
        model::allowed_current(limits, model::Celsius(plant.hottest_winding_c())).value;
    const model::Vec3 squares = allowed * allowed * shares;
    plant.step_thermal(squares, 1.0, 0.1);
    for (int ms = 0; ms < 100; ++ms) {
      for (int k = 0; k < 3; ++k) winding[k].step(static_cast<std::uint32_t>(1e6 * squares[k]));
      device.step(static_cast<std::uint32_t>(1e6 * allowed * allowed));
    }
    for (const HeatBudget& one : winding)
      max_share = std::max(max_share, one.permille(board.winding_a2s));
    max_share = std::max(max_share, device.permille(board.device_a2s));
  }
  return max_share / 1000.0;
}

TEST(BoardHeat, ToleratesWhatTheLimiterAllowsOnBallsTwentyPercentStronger) {
  const model::Vec3 one{1, 0, 0};
  const model::Vec3 two{0.5, 0.5, 0};
  const model::Vec3 three{1.0 / 3, 1.0 / 3, 1.0 / 3};
  for (const model::Vec3& shares : {one, two, three}) {
    EXPECT_LT(fullest_budget(shares, 1.2, 18.0), 0.96);
    EXPECT_LT(fullest_budget(shares, 1.0, 5.0), 1.0);
  }
  // The nominal ball reaches 1 / 1.3 of the budget: the budget has its stated margin and no more.
  EXPECT_NEAR(fullest_budget(one, 1.0, 18.0), 1 / 1.3, 0.02);
  EXPECT_NEAR(fullest_budget(three, 1.0, 18.0), 1 / 1.3, 0.02);
}

}  // namespace
}  // namespace hedgehog::board

// SPDX-License-Identifier: MIT
// The skin estimated from the core: against the plant, and its law.
#include "model/estimate/skin_estimate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "model/limit/shell_limit.h"
#include "model/thermal/plant.h"
#include "tests/model/thermal_loop.h"

namespace hedgehog::model {
namespace {

static_assert(std::is_trivially_copyable_v<SkinEstimate>);

constexpr double kStepS = 0.1;

SkinInputs inputs_of(const Plant& plant, double to_ambient_k_w) {
  SkinInputs in;
  in.nodes = plant.heat();
  in.ambient_c = plant.ambient_c();
  in.to_ambient_k_w = to_ambient_k_w;
  return in;
}

rc::Gen<double> between(double low, double high) {
  return rc::gen::map(
      rc::gen::inRange(0, 100'001),
      [=](int share) { return low + (high - low) * share / 100'000.0; });
}

RC_GTEST_PROP(CoreForecast, IsTheWarmestThatTheCoreGetsWithoutCurrent, ()) {
  const double ambient_c = *between(10.0, 35.0);
  const double core_c = ambient_c + *between(0.0, 35.0);
  ThermalState heat;
  heat.core_c = core_c;
  for (double& winding_c : heat.winding_c) winding_c = core_c + *between(0.0, 30.0);
  const bool fan = *rc::gen::arbitrary<bool>();
  ThermalModel thermal;
  thermal.winding_to_core_k_w.fill(*rc::gen::element(0.5, 1.0, 2.0));
  Plant plant(PlantParameters::of(CoilModel{}, thermal), ambient_c);
  // the fan spins up
  for (int i = 0; i < 100; ++i) plant.step_thermal({}, fan ? 1.0 : 0.0, kStepS);
  plant.set_heat(heat);
  double warmest_c = core_c;
  for (double t_s = 0.0; t_s < 200.0; t_s += kStepS) {
    plant.step_thermal({}, fan ? 1.0 : 0.0, kStepS);
    warmest_c = std::max(warmest_c, plant.heat().core_c);
  }
  const double to_ambient_k_w =
      fan ? thermal.core_to_ambient_fan_k_w : thermal.core_to_ambient_still_k_w;
  const double forecast_c = forecast_core_c(thermal, heat, ambient_c, to_ambient_k_w);
  RC_ASSERT(forecast_c >= core_c);
  RC_ASSERT(std::abs(forecast_c - warmest_c) < 0.05);
}

TEST(CoreForecast, OfABallAtRestIsItsCore) {
  EXPECT_EQ(forecast_core_c({}, {}, 25.0, 1.8), 25.0);
  EXPECT_EQ(forecast_core_c({}, {{40, 40, 40}, 40.0}, 25.0, 1.8), 40.0);
  EXPECT_EQ(forecast_core_c({}, {{40, 40, 40}, 40.0}, 45.0, 1.8), 40.0) << "colder than its room";
}

TEST(CoreForecast, OfACoreAtTheAmbientRisesByTheHeatOfItsWindings) {
  EXPECT_GT(forecast_core_c({}, {{60, 60, 60}, 25.0}, 25.0, 1.8), 30.0);
}

TEST(SkinInputs, AreOfTheFanAndTheCoolingThatTheFilterFound) {
  ThermalModel thermal;
  thermal.core_to_ambient_fan_k_w = 2.0;
  thermal.core_to_ambient_still_k_w = 6.0;
  EXPECT_EQ(SkinInputs::of(thermal, ThermalState{}, 21.0, true).to_ambient_k_w, 2.0);
  EXPECT_EQ(SkinInputs::of(thermal, ThermalState{}, 21.0, false).to_ambient_k_w, 6.0);
  EXPECT_EQ(SkinInputs::of(thermal, ThermalState{}, 21.0, false).ambient_c, 21.0);
  FilterStart start;
  start.nodes = {{50.0, 50.0, 50.0}, 50.0};
  ThermalFilter filter(CoilModel{}, thermal, {}, start);
  for (int i = 0; i < 6000; ++i) {
    filter.predict({}, false, 0.1);
    for (int coil = 0; coil < kCoils; ++coil) filter.thermistor(coil, 50.0);
  }
  ASSERT_LT(filter.cooling(), 0.9) << "it stays warm";
  const SkinInputs in = SkinInputs::of(thermal, filter, false);
  EXPECT_DOUBLE_EQ(in.to_ambient_k_w, 6.0 / filter.cooling());
  EXPECT_EQ(in.deviation_k, filter.between_deviation_k(0.7));
  EXPECT_GT(in.deviation_k, 0.0);
}

RC_GTEST_PROP(SkinEstimate, IsNeverBelowTheSkinOfAPlantThatMatches, ()) {
  const double ambient_c = *between(15.0, 35.0);
  Plant plant(PlantParameters{}, ambient_c);
  SkinEstimate skin{ThermalModel{}};
  for (int piece = 0; piece < 12; ++piece) {
    const Vec3 squares{*between(0.0, 75.0), *between(0.0, 75.0), *between(0.0, 75.0)};
    const bool fan = *rc::gen::arbitrary<bool>();
    const int steps = *rc::gen::inRange(10, 2000);
    for (int i = 0; i < steps; ++i) {
      plant.step_thermal(squares, fan ? 1.0 : 0.0, kStepS);
      skin.step(inputs_of(plant, fan ? 1.8 : 5.0), kStepS);
      RC_ASSERT(skin.celsius() >= plant.skin_c());
      RC_ASSERT(std::abs(skin.following_c() - plant.skin_c()) < 0.5);
    }
  }
}

TEST(SkinEstimate, OfAColdBallIsTheAmbientAndTheMinimumMargin) {
  SkinEstimate skin{ThermalModel{}};
  EXPECT_EQ(skin.celsius(), std::numeric_limits<double>::infinity()) << "nothing is known yet";
  skin.step(1e-3);
  EXPECT_EQ(skin.celsius(), std::numeric_limits<double>::infinity()) << "no inputs are known yet";
  skin.step({}, 1e-3);
  EXPECT_NEAR(skin.celsius(), 25.0 + SkinEstimate::kMinMarginK, 1e-9);
  EXPECT_EQ(skin.forecast_rise_k(), 0.0);
}

TEST(SkinEstimate, StartsAsWarmAsTheCoreMakesIt) {
  SkinEstimate skin{ThermalModel{}};
  SkinInputs warm;
  warm.nodes = {{50, 50, 50}, 50};
  skin.step(warm, 1e-3);
  EXPECT_NEAR(skin.following_c(), 25.0 + 0.7 * 25.0, 1e-9);
}

RC_GTEST_PROP(SkinEstimate, InTwoPartsWithSeldomInputsIsTheSameAsInEachStep, ()) {
  SkinEstimate at_once{ThermalModel{}};
  SkinEstimate in_parts{ThermalModel{}};
  for (int window = 0; window < 5; ++window) {
    SkinInputs in;
    in.nodes.core_c = *between(20.0, 60.0);
    in.nodes.winding_c.fill(*between(20.0, 80.0));
    in.deviation_k = *between(0.0, 5.0);
    in_parts.set(in);
    for (int i = 0; i < 50; ++i) {
      const double dt_s = *rc::gen::element(1e-3, 2e-3, 2e-2);
      at_once.step(in, dt_s);
      in_parts.step(dt_s);
      RC_ASSERT(in_parts.celsius() == at_once.celsius());
      RC_ASSERT(in_parts.following_c() == at_once.following_c());
    }
  }
}

TEST(SkinEstimate, IsHigherForALessCertainEstimateWithinLimits) {
  SkinInputs in;
  for (const auto& [deviation_k, margin_k] :
       {std::pair{0.3, 1.3}, {2.0, 1.6}, {3.0, 2.4}, {20.0, 3.0}}) {
    SkinEstimate skin{ThermalModel{}};
    in.deviation_k = deviation_k;
    skin.step(in, 1e-3);
    EXPECT_NEAR(skin.margin_k(), margin_k, 1e-9) << deviation_k;
    EXPECT_NEAR(skin.celsius(), 25.0 + margin_k, 1e-9) << deviation_k;
  }
}

TEST(SkinEstimate, WithAnInvalidNumberAllowsNothing) {
  for (const double none : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    SkinEstimate skin{ThermalModel{}};
    SkinInputs in;
    in.nodes.core_c = none;
    skin.step(in, 1e-3);
    EXPECT_EQ(shell_allowed_current(Limits{}, skin.celsius()).value, 0.0) << none;
  }
}

TEST(SkinEstimate, GivesTheSameBitsAgain) {
  std::array<SkinEstimate, 2> skins{SkinEstimate{ThermalModel{}}, SkinEstimate{ThermalModel{}}};
  std::array<double, 2> last{};
  for (std::size_t k = 0; k < 2; ++k) {
    ThermalLoop loop(random_plant(7), 28.0);
    for (int i = 0; i < 20'000; ++i) {
      loop.coarse_tick({0, i % 4000 < 3000 ? 9.0 : 0.0, 3});
      skins[k].step(SkinInputs::of({}, loop.observer.filter(), true), ThermalLoop::kCoarseS);
    }
    last[k] = skins[k].celsius();
  }
  EXPECT_EQ(std::memcmp(&last[0], &last[1], sizeof(double)), 0);
}

// With the observer's estimate of a ball that differs from its device file.
TEST(SkinEstimate, IsNotBelowTheSkinOfBallsThatDifferByAFifth) {
  double below_skin_k = -10.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const PlantParameters real = random_plant(seed);
    ThermalLoop loop(real, 18.0 + static_cast<double>(seed), device_file_of(real));
    SkinEstimate skin{ThermalModel{}};
    for (int i = 0; i < 60'000; ++i) {
      loop.coarse_tick(i % 20'000 < 15'000 ? Vec3{5, 3, -4} : Vec3{});
      skin.step(SkinInputs::of({}, loop.observer.filter(), loop.plant.fan_rpm() > 300.0),
                ThermalLoop::kCoarseS);
      below_skin_k = std::max(below_skin_k, loop.plant.skin_c() - skin.celsius());
    }
  }
  EXPECT_LT(below_skin_k, 0.0);
}

TEST(ShellLimit, FallsFromFullToZero) {
  const Limits limits;
  EXPECT_EQ(shell_allowed_current(limits, 20.0).value, 15.0);
  EXPECT_EQ(shell_allowed_current(limits, 38.0).value, 15.0);
  EXPECT_NEAR(shell_allowed_current(limits, 40.4).value, std::sqrt(125.0), 1e-9);
  EXPECT_NEAR(shell_allowed_current(limits, 42.8).value, 5.0, 1e-9);
  EXPECT_NEAR(shell_allowed_current(limits, 42.9).value, 2.5, 1e-9);
  EXPECT_EQ(shell_allowed_current(limits, 43.0).value, 0.0);
  EXPECT_EQ(shell_allowed_current(limits, std::nan("")).value, 0.0);
}

TEST(ShellLimit, NeverAllowsMoreThanTheLimits) {
  Limits tight;
  tight.current_a = 4.0;
  EXPECT_EQ(shell_allowed_current(tight, 20.0).value, 4.0);
  EXPECT_EQ(shell_allowed_current(tight, 42.8).value, 4.0);
  EXPECT_NEAR(shell_allowed_current(tight, 42.9).value, 2.5, 1e-9);
}

RC_GTEST_PROP(ShellLimit, IsTheInverseOfItsDeratingTemperature, ()) {
  const double peak_a = *between(0.01, 15.0);
  const double at_c = shell_derating_temperature(Amps(peak_a)).value;
  RC_ASSERT(std::abs(shell_allowed_current(Limits{}, at_c).value - peak_a) < 1e-6);
}

}  // namespace
}  // namespace hedgehog::model

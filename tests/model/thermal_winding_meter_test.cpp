// SPDX-License-Identifier: MIT
#include "model/estimate/thermal_winding_meter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "model/thermal/plant.h"

namespace hedgehog::model {
namespace {

/// Drives winding x of `plant` with `current_at(seconds)` and feeds the measurements to the meter.
struct Bench {
  Plant plant;
  WindingMeter meter{1.5e-3};
  double worst_k = 0.0;
  double longest_gap_s = 0.0;

  void run(double seconds, const std::function<double(double)>& current_at) {
    double gap_s = 0.0;
    const int ticks = static_cast<int>(std::lround(seconds * 1e3));
    for (int tick = 0; tick < ticks; ++tick) {
      const double before = plant.current_a().x;
      PlantInputs inputs;
      inputs.bridge.fill(BridgeState::kDriven);
      inputs.voltage_v.x = std::clamp(
          0.45 * current_at(tick * 1e-3) + 1.5 * (current_at(tick * 1e-3) - before), -12.0, 12.0);
      plant.step(inputs, 1e-3);
      meter.step(inputs.voltage_v.x, before, plant.current_a().x, true, 1e-3);
      gap_s = meter.valid() ? 0.0 : gap_s + 1e-3;
      if (tick > 100) longest_gap_s = std::max(longest_gap_s, gap_s);
      if (!meter.valid()) continue;
      const double error = meter.resistance_ohm() / plant.resistance_ohm(0) - 1.0;
      worst_k = std::max(worst_k, std::abs(error) / kCopperPerKelvin);
    }
  }
};

PlantParameters inductance_off_by(double factor) {
  PlantParameters p;
  p.inductance_h *= factor;
  return p;
}

TEST(WindingMeter, IsValidWithinTensOfMillisecondsAtFiveAmpere) {
  Bench bench{Plant(PlantParameters{}, 25.0)};
  bench.run(0.03, [](double) { return 5.0; });
  EXPECT_TRUE(bench.meter.valid());
  EXPECT_LT(bench.worst_k, 0.5);
}

TEST(WindingMeter, IsInvalidBelowOneAndAHalfAmpere) {
  Bench low{Plant(PlantParameters{}, 25.0)};
  low.run(2.0, [](double) { return 1.1; });
  EXPECT_FALSE(low.meter.valid());
  Bench enough{Plant(PlantParameters{}, 25.0)};
  enough.run(0.2, [](double) { return 1.6; });
  EXPECT_TRUE(enough.meter.valid());
}

TEST(WindingMeter, ResetsWhenTheCurrentEnds) {
  Bench bench{Plant(PlantParameters{}, 25.0)};
  bench.run(0.5, [](double) { return 8.0; });
  ASSERT_TRUE(bench.meter.valid());
  bench.run(0.5, [](double) { return 0.0; });
  EXPECT_FALSE(bench.meter.valid());
  EXPECT_NEAR(bench.meter.resistance_ohm(), 0.45, 0.01);
}

TEST(WindingMeter, ShowsNoCurrentBeforeItHasMeasuredAny) {
  WindingMeter meter(1.5e-3);
  EXPECT_EQ(meter.current_a(), 0.0);
  meter.step(0.9, 2.0, 2.0, true, 1e-3);
  EXPECT_NEAR(meter.current_a(), 2.0, 1e-9);
}

TEST(WindingMeter, UnmeasuredStepsAreIgnored) {
  WindingMeter meter(1.5e-3);
  for (int tick = 0; tick < 500; ++tick) meter.step(9.0, 5.0, 5.0, false, 1e-3);
  EXPECT_FALSE(meter.valid());
}

TEST(WindingMeter, FollowsAnyWaveformThoughTheInductanceIsOffByAFifth) {
  for (const double factor : {0.8, 1.0, 1.2}) {
    Bench square{Plant(inductance_off_by(factor), 25.0)};
    square.run(5.0, [](double t) { return std::fmod(60.0 * t, 1.0) < 0.5 ? 9.0 : 0.0; });
    EXPECT_LT(square.worst_k, 0.5) << factor;
    EXPECT_LT(square.longest_gap_s, 0.01);

    Bench sine{Plant(inductance_off_by(factor), 25.0)};
    sine.run(5.0,
             [](double t) { return 3.5 * (1.0 + std::sin(2.0 * std::numbers::pi * 200.0 * t)); });
    EXPECT_LT(sine.worst_k, 0.5) << factor;
    EXPECT_LT(sine.longest_gap_s, 0.01);
  }
}

TEST(WindingMeter, MeasuresPulseTrainsHotterThanFiveAmpere) {
  Bench bench{Plant(PlantParameters{}, 25.0)};
  bench.run(5.0, [](double t) { return std::fmod(60.0 * t, 1.0) < 0.15 ? 15.0 : 0.0; });
  EXPECT_LT(bench.longest_gap_s, 0.02);
  EXPECT_LT(bench.worst_k, 1.0);
}

}  // namespace
}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// The sum of duty times current compared with the current of the supply.
#include "daemon/control/checks/supply_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <utility>

#include "model/random_stream.h"
#include "model/tick.h"

namespace hedgehog::control {
namespace {

static_assert(std::is_trivially_copyable_v<SupplyBalance>);

using model::kTickSeconds;
using model::Vec3;

/// A board whose windings carry currents; each sensor with a gain error and noise.
struct SupplyBench {
  SupplyBalance balance;
  model::RandomStream random{7};
  Vec3 gain{1.0, 1.0, 1.0};
  double supply_gain = 1.0;
  double supply_offset_a = 0.0;
  double supply_v = 12.0;
  model::CurrentAccuracy accuracy = model::kInLineAccuracy;
  bool known = true;

  /// The first disagreement within `seconds`, or none.
  Disagreement run(const Vec3& current_a, double seconds) {
    const auto ticks = static_cast<int>(std::lround(seconds / kTickSeconds));
    for (int i = 0; i < ticks; ++i) {
      SupplyReading reading;
      reading.known = known;
      reading.accuracy = accuracy;
      reading.duty = (0.45 / 12.0) * current_a;
      reading.supply_current_a =
          supply_gain * dot(reading.duty, current_a) + supply_offset_a + 0.02 * random.gaussian();
      reading.supply_v = supply_v;
      for (int coil = 0; coil < model::kCoils; ++coil)
        reading.current_a[coil] = gain[coil] * current_a[coil] + 0.05 * random.gaussian();
      const Disagreement found = balance.step(reading, kTickSeconds);
      if (found.any()) return found;
    }
    return {};
  }
};

TEST(SupplyBalance, ToleratesTheTolerancesOfTheParts) {
  for (const double sign : {-1.0, 1.0}) {
    SupplyBench bench;
    bench.gain = {1.0 + 0.02 * sign, 1.0 - 0.02 * sign, 1.0 + 0.02 * sign};
    bench.supply_gain = 1.0 - 0.02 * sign;
    bench.supply_offset_a = 0.03 * sign;
    for (const Vec3& current : {Vec3{15, 0, 0}, Vec3{0, 8, 0}, Vec3{-4, 6, 9}, Vec3{5, 5, 5}})
      EXPECT_FALSE(bench.run(current, 60.0).any()) << sign;
  }
}

TEST(SupplyBalance, NamesAWindingWhoseCurrentReadsTenPercentHigh) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    SupplyBench bench;
    Vec3 along;
    along[coil] = 12.0;
    ASSERT_FALSE(bench.run(along, 10.0).any());
    bench.gain[coil] = 1.1;
    const Disagreement found = bench.run(along, 2.0);
    EXPECT_EQ(found, (Disagreement{coil, Quantity::kCurrent, Quantity::kSupplyCurrent}));
  }
}

TEST(SupplyBalance, AGainIsFoundWhenItExceedsTheToleranceByTwoDeviations) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    for (const auto& [gain, found] : {std::pair{1.054, false}, {1.062, true}}) {
      SupplyBench bench;
      bench.gain[coil] = gain;
      Vec3 along;
      along[coil] = 12.0;
      EXPECT_EQ(bench.run(along, 60.0),
                found ? (Disagreement{coil, Quantity::kCurrent, Quantity::kSupplyCurrent})
                      : Disagreement{})
          << coil << ", " << gain;
    }
  }
}

TEST(SupplyBalance, AnOffsetOfTheSupplysCurrentIsNoGain) {
  SupplyBench bench;
  bench.supply_offset_a = 0.08;
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(bench.run({4, 0, 0}, 5.0).any());
    EXPECT_FALSE(bench.run({0, 12, 0}, 5.0).any());
    EXPECT_FALSE(bench.run({0, 5, 9}, 5.0).any());
  }
}

TEST(SupplyBalance, ToleratesMoreOfSensorsWithoutZeroing) {
  for (const auto& [gain, found] : {std::pair{0.95, false}, {0.92, true}}) {
    SupplyBench bench;
    bench.accuracy = model::kDriverCsAccuracy;
    bench.gain[1] = gain;
    EXPECT_EQ(bench.run({0, 12, 0}, 60.0).any(), found) << gain;
  }
}

TEST(SupplyBalance, AVoltageThatHasHardlyChangedExplainsNoSmallChange) {
  SupplyBench bench;
  bench.run({0, 12, 0}, 10.0);
  bench.supply_v = 12.0 * 1.0035;
  bench.run({0, 12, 0}, 2.0);
  EXPECT_FALSE(
      bench.balance.moved(1, 0.01, SupplyBalance::Since::kStart).has(Quantity::kSupplyVoltage));
  bench.supply_v = 12.0 * 1.006;
  bench.run({0, 12, 0}, 2.0);
  EXPECT_TRUE(
      bench.balance.moved(1, 0.01, SupplyBalance::Since::kStart).has(Quantity::kSupplyVoltage));
}

TEST(SupplyBalance, NamesWhatElseHasMovedWithVI) {
  const Vec3 along{0, 12, 0};
  const auto moved = [&](auto&& change, double share) {
    SupplyBench bench;
    bench.run(along, 10.0);
    change(bench);
    bench.run(along, 2.0);
    return bench.balance.moved(1, share, SupplyBalance::Since::kStart);
  };
  EXPECT_EQ(moved([](SupplyBench&) {}, -0.03),
            (Disagreement{1, Quantity::kResistance, Quantity::kHeatBalance}));
  EXPECT_EQ(moved([](SupplyBench& bench) { bench.gain[1] = 1.03; }, -0.03),
            (Disagreement{1, Quantity::kCurrent, Quantity::kSupplyCurrent}));
  EXPECT_EQ(moved([](SupplyBench& bench) { bench.supply_v = 11.6; }, -0.033),
            (Disagreement{1, Quantity::kSupplyVoltage, Quantity::kHeatBalance}));
}

// When a step of V/I trips, and while the limiter reduces, the supply current has not settled yet.
TEST(SupplyBalance, NamesTheCurrentTooATenthOfASecondAfterItsGainHasChanged) {
  for (const double gain : {0.8, 0.95, 1.2}) {
    SupplyBench bench;
    bench.run({0, 12, 0}, 10.0);
    bench.gain[1] = gain;
    bench.run({0, 12, 0}, 0.1);
    const Disagreement found =
        bench.balance.moved(1, -std::log(gain), SupplyBalance::Since::kStart);
    EXPECT_EQ(
        found,
        (Disagreement{1, Quantity::kResistance, Quantity::kHeatBalance}.with(Quantity::kCurrent)))
        << gain;
  }
}

// An overheated reading trips within 50 ms.
TEST(SupplyBalance, ByItsLastWindowItNamesAChangeOfFiftyMilliseconds) {
  const auto moved = [](const Vec3& gain, double supply_v, double share) {
    SupplyBench bench;
    bench.run({0, 12, 0}, 10.0);
    bench.gain = gain;
    bench.supply_v = supply_v;
    bench.run({0, 12, 0}, 0.05);
    return bench.balance.moved(1, share, SupplyBalance::Since::kStart,
                               SupplyBalance::By::kLastWindow);
  };
  EXPECT_EQ(moved({1.0, 1.0, 1.0}, 12.0, 0.1),
            (Disagreement{1, Quantity::kResistance, Quantity::kHeatBalance}));
  EXPECT_EQ(moved({1.0, 0.9, 1.0}, 12.0, 0.1),
            (Disagreement{1, Quantity::kCurrent, Quantity::kSupplyCurrent}));
  EXPECT_EQ(moved({1.0, 1.0, 1.0}, 13.2, 0.1),
            (Disagreement{1, Quantity::kSupplyVoltage, Quantity::kHeatBalance}));
}

TEST(SupplyBalance, ALastWindowOfMoreThanATenthOfASecondAgoExcludesNothing) {
  for (const auto& [silent_s, excluded] : {std::pair{0.08, true}, {0.14, false}}) {
    SupplyBench bench;
    bench.run({0, 12, 0}, 10.0);
    bench.known = false;
    bench.run({0, 12, 0}, silent_s);
    const Disagreement found =
        bench.balance.moved(1, 0.1, SupplyBalance::Since::kStart, SupplyBalance::By::kLastWindow);
    EXPECT_EQ(found.has(Quantity::kCurrent), !excluded) << silent_s;
  }
}

TEST(SupplyBalance, ASupplyThatIsNotMeasuredExplainsNothing) {
  for (const double share : {-0.1, 0.1}) {
    const Disagreement found = SupplyBalance().moved(1, share, SupplyBalance::Since::kFile);
    EXPECT_FALSE(found.has(Quantity::kSupplyVoltage)) << share;
    EXPECT_TRUE(found.has(Quantity::kCurrent)) << share;
  }
}

TEST(SupplyBalance, AQuantityThatMovedTheOtherWayIsNotExcluded) {
  const auto moved = [](double gain, double supply_v, double share) {
    SupplyBench bench;
    bench.run({0, 12, 0}, 10.0);
    bench.gain[1] = gain;
    bench.supply_v = supply_v;
    bench.run({0, 12, 0}, 2.0);
    return bench.balance.moved(1, share, SupplyBalance::Since::kStart);
  };
  EXPECT_TRUE(moved(1.03, 12.0, 0.03).has(Quantity::kCurrent));
  EXPECT_TRUE(moved(1.0, 11.6, 0.033).has(Quantity::kSupplyVoltage));
}

TEST(SupplyBalance, WithoutObservationsItNamesBoth) {
  const SupplyBalance fresh;
  const Disagreement found = fresh.moved(2, -0.05, SupplyBalance::Since::kStart);
  EXPECT_TRUE(found.has(Quantity::kResistance));
  EXPECT_TRUE(found.has(Quantity::kCurrent));
  EXPECT_EQ(found.coil(), 2);
}

}  // namespace
}  // namespace hedgehog::control

// SPDX-License-Identifier: MIT
// Observer, limiter and plant in a loop: the thermal guarantees of daemon/safety.md.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "tests/model/thermal_loop.h"
#include "tests/rig/sanitized.h"

namespace hedgehog::model {
namespace {

constexpr int kCoarsePerHour = 3600 * 50;
constexpr double kWorstWindingC = 73.5;
constexpr double kWorstWithSensorFaultC = 73.1;
constexpr double kTripHoldS = 0.05;

Vec3 along(int coil, double current) {
  Vec3 v;
  v[coil] = current;
  return v;
}

class FiveAmpere : public testing::TestWithParam<Vec3> {};

TEST_P(FiveAmpere, IsNeverReducedInFourHours) {
  ThermalLoop loop(PlantParameters{}, 25.0);
  for (int step = 0; step < 4 * kCoarsePerHour; ++step) {
    loop.coarse_tick(GetParam());
    ASSERT_EQ(loop.driven, GetParam()) << "after " << step * 20e-3 << " s";
  }
  EXPECT_EQ(loop.longest_above_trip_s, 0.0);
  EXPECT_GT(loop.hottest_ever_c, 50.0);
}

TEST_P(FiveAmpere, IsNeverReducedAtOneMillisecondEither) {
  ThermalLoop loop(PlantParameters{}, 25.0);
  for (int tick = 0; tick < 1'200'000; ++tick) {
    loop.tick(GetParam());
    ASSERT_EQ(loop.driven, GetParam()) << "after " << tick << " ms";
  }
  EXPECT_NEAR(norm(loop.plant.current_a()), 5.0, 0.05);
}

std::string axis_name(const testing::TestParamInfo<Vec3>& axis) {
  constexpr const char* kNames[] = {"x", "y", "z", "minus_x", "oblique"};
  return kNames[axis.index];
}

INSTANTIATE_TEST_SUITE_P(Axes, FiveAmpere,
                         testing::Values(Vec3{5, 0, 0}, Vec3{0, 5, 0}, Vec3{0, 0, 5},
                                         Vec3{-5, 0, 0}, Vec3{3, 0, -4}),
                         axis_name);

TEST(HeatLoop, FifteenAmpereAreFullFor22SecondsThenReduced) {
  for (int coil = 0; coil < kCoils; ++coil) {
    ThermalLoop loop(PlantParameters{}, 25.0);
    double full_s = 0.0;
    double after_32_s = 0.0;
    for (int tick = 1; tick <= 300'000; ++tick) {
      loop.tick(along(coil, 15.0));
      if (norm(loop.driven) > 15.0 - 1e-9) full_s = tick * 1e-3;
      if (tick == 32'000) after_32_s = norm(loop.driven);
    }
    EXPECT_NEAR(full_s, 22.0, 1.0);
    EXPECT_NEAR(after_32_s, 8.5, 0.5) << "one thermistor costs half a kelvin";
    EXPECT_GT(norm(loop.driven), 5.0) << "reduced, never cut";
    EXPECT_LT(loop.hottest_ever_c, 67.0);
    EXPECT_EQ(loop.longest_above_trip_s, 0.0);
  }
}

TEST(HeatLoop, SensorNoiseDipsTheLimitByLessThanTwoAmpere) {
  PlantParameters noisy_plant;
  noisy_plant.sensor_noise_k = 0.15;
  ThermalLoop with(noisy_plant, 32.0);
  ThermalLoop without(PlantParameters{}, 32.0);
  with.fan_works = without.fan_works = false;  // the only way to stay above 67 C
  double deepest_a = 0.0;
  double warmest_c = 0.0;
  for (int tick = 0; tick < 1'800'000; ++tick) {
    with.tick({15, 0, 0});
    without.tick({15, 0, 0});
    warmest_c = std::max(warmest_c, without.observer.estimate().hottest_c);
    deepest_a = std::max(deepest_a, without.limiter.allowed().value - with.limiter.allowed().value);
  }
  EXPECT_GT(warmest_c, 67.0);
  EXPECT_LT(deepest_a, 2.0);
}

/// The most demanding load profiles, by number.
class Demand {
 public:
  Demand(int kind, std::uint64_t seed) : kind_(kind), random_(seed) {}
  static constexpr int kKinds = 6;

  Vec3 at(double t_s, double hottest_c) {
    const double each = 15.0 / std::sqrt(3.0);
    switch (kind_) {
      case 0:
        return along(0, 15.0);
      case 1:
        return along(static_cast<int>(t_s / 7.0) % kCoils, 15.0);
      case 2:  // one coil after the other, then a rest in which thermistor and windings diverge
        return std::fmod(t_s, 300.0) > 200.0 ? Vec3{} : along(static_cast<int>(t_s / 20.0) % 3, 15);
      case 3:
        return hottest_c < 60.0 ? along(1, 15.0) : Vec3{};
      case 4:
        return {each, -each, each};
      default:
        if (t_s >= until_s_) draw(t_s);
        return held_;
    }
  }

 private:
  void draw(double t_s) {
    until_s_ = t_s + random_.uniform(0.2, 40.0);
    held_ = {random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
    if (random_.uniform(0, 1) < 0.6) held_ = along(static_cast<int>(random_.bits() % 3), 1.0);
    held_ = random_.uniform(3.0, 18.0) * unit_or(held_, {1, 0, 0});
    if (random_.uniform(0, 1) < 0.2) held_ = {};
  }

  int kind_;
  RandomStream random_;
  Vec3 held_;
  double until_s_ = 0.0;
};

TEST(HeatLoop, AnHourOfTheWorstOnRandomBallsNeitherTripsNorOverheats) {
  for (std::uint64_t seed = 1; seed <= repetitions(48U); ++seed) {
    const PlantParameters real = random_plant(seed);
    RandomStream random(seed + 10'000);
    ThermalLoop loop(real, random.uniform(18.0, 32.0), device_file_of(real));
    Demand demand(static_cast<int>(seed) % Demand::kKinds, seed);
    for (int step = 0; step < kCoarsePerHour; ++step)
      loop.coarse_tick(demand.at(step * 20e-3, loop.observer.estimate().hottest_c));
    EXPECT_LT(loop.hottest_ever_c, kWorstWindingC) << "ball " << seed;
    EXPECT_GT(loop.hottest_ever_c, 55.0) << "the demand was no demand, ball " << seed;
    EXPECT_LT(loop.longest_above_trip_s, kTripHoldS) << "ball " << seed;
  }
}

TEST(HeatLoop, TheSameAtOneMillisecond) {
  for (std::uint64_t seed = 101; seed <= 100 + repetitions(4U); ++seed) {
    const PlantParameters real = random_plant(seed);
    ThermalLoop loop(real, 32.0, device_file_of(real));
    Demand demand(static_cast<int>(seed) % Demand::kKinds, seed);
    for (int tick = 0; tick < 1'800'000; ++tick)
      loop.tick(demand.at(tick * 1e-3, loop.observer.estimate().hottest_c));
    EXPECT_LT(loop.hottest_ever_c, kWorstWindingC) << "ball " << seed;
    EXPECT_LT(loop.longest_above_trip_s, kTripHoldS) << "ball " << seed;
  }
}

/// The reading of a thermistor with this fault while its true temperature is `true_c`.
double faulty_reading(int fault, double t_s, double true_c, double first_c) {
  switch (fault) {
    case 0:
      return first_c;  // frozen from the start
    case 1:
      return std::max(10.0, true_c - 0.5 * std::max(0.0, t_s - 60.0));  // detaching
    case 2:
      return t_s > 15.0 ? true_c - 30.0 : true_c;  // jumps down
    case 3:
      return std::fmod(t_s, 2.0) < 1.0 ? true_c : true_c - 40.0;  // a loose contact
    default:
      return 20.0;
  }
}

// Without the watchdog, which would have cut the current after half a second.
TEST(HeatLoop, AThermistorThatReadsLowDoesNotBurnAWindingThoughR25IsOffByOnePercent) {
  for (int fault = 0; fault < 5; ++fault) {
    for (std::uint64_t seed = 1; seed <= repetitions(12U); ++seed) {
      const PlantParameters real = random_plant(100 * seed + static_cast<std::uint64_t>(fault));
      CoilModel known = device_file_of(real);
      for (double& r25 : known.r25_ohm) r25 *= 1.01;
      ThermalLoop loop(real, 32.0, known);
      Demand demand(static_cast<int>(seed) % Demand::kKinds, seed);
      const double first_c = loop.plant.sensor_c();
      for (int step = 0; step < kCoarsePerHour / 2; ++step) {
        const double t_s = step * 20e-3;
        loop.coarse_tick(demand.at(t_s, loop.observer.estimate().hottest_c),
                         faulty_reading(fault, t_s, loop.plant.sensor_c(), first_c));
      }
      EXPECT_LT(loop.hottest_ever_c, kWorstWithSensorFaultC) << "fault " << fault << " " << seed;
      EXPECT_GT(loop.hottest_ever_c, 55.0);
    }
  }
}

TEST(HeatLoop, AnOpenThermistorEndsTheCurrentInATenthOfASecond) {
  ThermalLoop loop(PlantParameters{}, 25.0);
  for (int tick = 0; tick < 1000; ++tick) loop.tick({5, 0, 0});
  for (int tick = 0; tick < 105; ++tick) loop.tick({5, 0, 0}, 0.0, false);
  EXPECT_EQ(loop.driven, Vec3{});
}

TEST(HeatLoop, AThermistorThatJumpsUpIsTreatedAsHot) {
  ThermalLoop loop(PlantParameters{}, 25.0);
  for (int tick = 0; tick < 5000; ++tick) loop.tick({0, 15, 0});
  ASSERT_NEAR(norm(loop.driven), 15.0, 1e-9);
  for (int tick = 0; tick < 1000; ++tick) loop.tick({0, 15, 0}, loop.plant.sensor_c() + 45.0);
  EXPECT_EQ(loop.driven, Vec3{});
}

// A restart without saved temperatures: windings at 60 C, thermistor at 40 C; the thermistor is the
// only information.
TEST(HeatLoop, AfterARestartAHotWindingIsFoundBeforeItIsDrivenHard) {
  ThermalLoop loop(PlantParameters{}, 25.0);
  loop.start_at({{40.0, 65.0, 40.0}, 40.0});
  loop.observer = ThermalObserver(CoilModel{}, ThermalModel{}, {{{40, 40, 40}, 40}});
  loop.tick({0, 15, 0});
  EXPECT_NEAR(norm(loop.driven), 5.0, 1e-9);
  for (int tick = 0; tick < 400; ++tick) loop.tick({0, 15, 0});
  EXPECT_GT(loop.observer.estimate().upper_c[1], loop.plant.heat().winding_c[1]);
  EXPECT_LT(norm(loop.driven), 10.0);
  EXPECT_LT(loop.hottest_ever_c, 67.5);
}

TEST(ThermalObserver, ItsEstimateIsThatOfItsFilterAtEachTick) {
  ThermalLoop loop(random_plant(3), 25.0);
  for (int tick = 0; tick < 1000; ++tick) {
    loop.tick({9, 3, 0});
    const ThermalEstimate& estimate = loop.observer.estimate();
    const ThermalFilter& filter = loop.observer.filter();
    ASSERT_EQ(estimate.nodes.winding_c, filter.nodes().winding_c) << tick;
    ASSERT_EQ(estimate.ambient_c, filter.ambient_c()) << tick;
    for (int coil = 0; coil < kCoils; ++coil) {
      const auto i = static_cast<std::size_t>(coil);
      ASSERT_EQ(estimate.deviation_k[i], filter.winding_deviation_k(coil)) << tick;
    }
    // without current only the filter knows its resistance; a loss is computed before a window ends
    if (!loop.observer.window_ended())
      ASSERT_EQ(estimate.resistance_ohm[2], filter.resistance_ohm(2)) << tick;
  }
}

}  // namespace
}  // namespace hedgehog::model

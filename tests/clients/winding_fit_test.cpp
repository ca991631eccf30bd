// SPDX-License-Identifier: MIT
// Resistance and inductance from samples of a winding, and how accurate they are.
#include "clients/ctl/calibrate/winding_fit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace hedgehog::client {
namespace {

// Samples of a winding with the voltages of each millisecond, every fifth millisecond.
std::vector<WindingSample> driven(double r, double l, double frequency_hz, double offset_a,
                                  int every_ms = 5) {
  std::vector<WindingSample> seen;
  const double decay = std::exp(-r * 1e-3 / l);
  double current_a = 0.0;
  for (int ms = 0; ms < 1400; ++ms) {
    const double t_s = 1e-3 * ms;
    const double v = 0.3 + 0.5 * std::sin(2.0 * std::numbers::pi * frequency_hz * t_s);
    current_a = decay * current_a + (1.0 - decay) / r * v;
    if (ms >= 200 && ms % every_ms == 0) seen.push_back({t_s, current_a + offset_a, v});
  }
  return seen;
}

RC_GTEST_PROP(WindingFit, FindsResistanceAndInductance, ()) {
  const double r = *rc::gen::inRange(20, 200) / 100.0;
  const double l = *rc::gen::inRange(30, 400) / 1e5;
  // a current that decays within the millisecond gives no information about L
  RC_PRE(std::exp(-r * 1e-3 / l) > 0.1);
  auto samples = driven(r, l, 47.0, 0.05);
  for (WindingSample& one : samples) one.current_a = std::round(1000.0 * one.current_a) / 1000.0;
  const auto found = sine_impedance(samples, 47.0);
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(found->resistance_ohm / r - 1.0) < 0.02);
  RC_ASSERT(std::abs(found->inductance_h / l - 1.0) < 0.02);
}

TEST(WindingFit, AFewSamplesAtIrregularTimesAreFittedExactly) {
  const auto all = driven(0.9, 0.001, 47.0, 0.0);
  std::vector<WindingSample> few;
  for (std::size_t i = 0, gap = 1; i < all.size(); i += gap++) few.push_back(all[i]);
  ASSERT_LT(few.size(), kMinSamples + 3);
  const auto found = sine_impedance(few, 47.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->resistance_ohm, 0.9, 1e-9);
  EXPECT_NEAR(found->inductance_h, 0.001, 1e-12);
}

TEST(WindingFit, AConstantErrorOfTheSensorCancels) {
  const std::vector<WindingSample> forth(10, {0.0, 1.0 + 0.07, 0.45});
  const std::vector<WindingSample> back(10, {0.0, -1.0 + 0.07, -0.45});
  EXPECT_NEAR(*steady_resistance(forth, back), 0.45, 1e-9);
  EXPECT_LT(*steady_resistance(back, {10, {0.0, 2.0, -3.0}}), 1e9);
  EXPECT_FALSE(steady_resistance({}, back));
  EXPECT_FALSE(steady_resistance({{0, 0.015, 0.45}}, {{0, -0.015, -0.45}})) << "nothing flows";
}

TEST(WindingFit, TheErrorFollowsTheScatterOfTheCurrents) {
  std::vector<WindingSample> forth(100, {0.0, 1.0, 0.45});
  std::vector<WindingSample> back(100, {0.0, -1.0, -0.45});
  EXPECT_EQ(steady_resistance_error(forth, back), 0.0);
  for (std::size_t i = 0; i < forth.size(); ++i)
    forth[i].current_a = back[i].current_a = i % 2 == 0 ? 1.04 : 0.96;
  for (WindingSample& one : back) one.current_a -= 2.0;
  EXPECT_NEAR(steady_resistance_error(forth, back), 0.04 / 2.0 * std::sqrt(2.0 / 100.0), 5e-5);
}

struct Measurement {
  double noise_a, noise_v;
  int every_ms;
  std::size_t first, count;
};

TEST(WindingFit, TheErrorOfTheInductanceIsHowFarItScatters) {
  constexpr int kRepetitions = 1600;
  constexpr Measurement kMeasurements[] = {
      {0.02, 0.0, 5, 0, 40},     {0.02, 0.0, 5, 1, 40},  // a quarter of a period later
      {0.0, 0.02, 5, 0, 40},     {0.0, 0.02, 5, 1, 40},
      {0.005, 0.005, 21, 0, 25},  // almost a period apart: sine and cosine are correlated
  };
  std::mt19937 random(1);
  for (const Measurement& one : kMeasurements) {
    SCOPED_TRACE(testing::Message() << one.noise_a << " A, " << one.noise_v << " V, every "
                                    << one.every_ms << " ms from " << one.first);
    std::normal_distribution<double> normal;
    const auto exact = driven(0.9, 0.001, 47.0, 0.0, one.every_ms);
    double squares = 0.0;
    double expected = 0.0;
    for (int i = 0; i < kRepetitions; ++i) {
      std::vector<WindingSample> samples;
      for (std::size_t at = one.first; at < one.first + one.count; ++at) {
        samples.push_back(exact.at(at));
        samples.back().current_a += one.noise_a * normal(random);
        samples.back().voltage_v += one.noise_v * normal(random);
      }
      const auto found = sine_impedance(samples, 47.0);
      ASSERT_TRUE(found);
      squares += std::pow(found->inductance_h / 0.001 - 1.0, 2.0);
      expected += std::pow(inductance_error(samples, 47.0), 2.0);
    }
    EXPECT_NEAR(std::sqrt(squares / expected), 1.0, 0.08);
  }
}

TEST(WindingFit, TheErrorOfTheInductanceIsNoneWithoutNoiseAndInfiniteWithoutSamples) {
  EXPECT_LT(inductance_error(driven(0.9, 0.001, 47.0, 0.0), 47.0), 1e-9);
  EXPECT_TRUE(std::isinf(inductance_error({}, 47.0)));
}

TEST(WindingFit, NoiseAndTooFewSamplesAreRejected) {
  EXPECT_FALSE(sine_impedance({}, 47.0));
  std::vector<WindingSample> flat(100, {0.0, 1.0, 0.45});
  for (std::size_t i = 0; i < flat.size(); ++i) flat[i].t_s = 5e-3 * static_cast<double>(i);
  EXPECT_FALSE(sine_impedance(flat, 47.0));
}

}  // namespace
}  // namespace hedgehog::client

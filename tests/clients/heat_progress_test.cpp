// SPDX-License-Identifier: MIT
// The samples of a heating run, and the file from which it resumes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "clients/ctl/calibrate/heat_bench.h"
#include "clients/ctl/calibrate/heat_progress.h"
#include "tests/temporary_folder.h"

namespace hedgehog::client {
namespace {

using testing::HasSubstr;

protocol::Description ball() {
  protocol::Description d;
  d.name = "ball-7";
  d.board.backend = "simulator";
  d.coils.r25_ohm = {0.45, 0.46, 0.44};
  return d;
}

protocol::TemperatureStatus shown(double celsius) {
  protocol::TemperatureStatus t;
  t.sensor = celsius;
  return t;
}

HeatProgress begun() {
  HeatProgress progress;
  progress.ball = identity_of(ball());
  progress.windings.name = "ball-7";
  progress.windings.r25_ohm = {0.45, 0.46, 0.44};
  progress.windings.sensor_c = 24.5;
  return progress;
}

model::HeatSample sample(double end_s) {
  model::HeatSample s;
  s.dt_s = 1.5;
  s.end_s = end_s;
  s.power_w = {3.8, 0.0, 0.0};
  s.voltage_v = {-1.3, 0.0, 0.0};
  s.current_a = {-2.9, 0.0, 0.0};
  s.count = 150;
  s.fan_running = true;
  if (end_s < 5.0) s.sensor_c = 25.1;
  return s;
}

TEST(HeatSample, PowerIsOfTheWholeTimeAndResistanceOfTheSettledEnd) {
  std::vector<HeatReading> readings;
  for (int k = 1; k <= 100; ++k) {
    const double current_a = k <= 20 ? 0.0 : 5.0;
    readings.push_back({0.01 * k, {0.45 * current_a, 0.0, 0.0}, {current_a, 0.0, 0.0}});
  }
  const model::HeatSample mean = mean_of(readings, 0.0);
  EXPECT_NEAR(mean.power_w[0], 0.8 * 5.0 * 5.0 * 0.45, 1e-9);
  EXPECT_NEAR(mean.voltage_v[0] / mean.current_a[0], 0.45, 1e-12);
  EXPECT_EQ(mean.count, 79) << "the first that is as large may still be on its way";
  EXPECT_DOUBLE_EQ(mean.dt_s, 1.0);
  const model::HeatSample single = mean_of({readings.back()}, 0.9);
  EXPECT_EQ(single.count, 0);
  EXPECT_EQ(single.current_a[0], 0.0);
}

TEST(HeatSample, TheRippleOfASupplyIsAveraged) {
  const double period_s =
      std::round(1000.0 / kHeatTelemetryHz) / 1000.0;  // as the daemon rounds it
  constexpr double kRippleShare = 0.0025;
  for (const double ripple_hz : {100.0, 120.0}) {
    for (double phase = 0.0; phase < 6.3; phase += 0.3) {
      std::vector<HeatReading> readings;
      for (double t_s = period_s; t_s <= 1.5; t_s += period_s) {
        const double ripple = std::sin(2.0 * std::numbers::pi * ripple_hz * t_s + phase);
        readings.push_back({t_s, {1.3 * (1.0 + kRippleShare * ripple), 0.0, 0.0}, {2.9, 0.0, 0.0}});
      }
      EXPECT_NEAR(mean_of(readings, 0.0).voltage_v[0], 1.3, 0.1 * kRippleShare * 1.3)
          << ripple_hz << " Hz, " << phase;
    }
  }
}

TEST(HeatProgress, ReadsBackFromItsFile) {
  TemporaryFolder folder;
  const std::string path = folder.path("ball.json.progress");
  {
    HeatProgressFile file(path, begun());
    ASSERT_TRUE(file.ok());
    file.add(sample(1.5), true, 0, 0);
    file.add(sample(3.0), true, 0, 1);
    file.add(sample(9.0), false, 1, 2);
  }
  const auto back = read_progress(folder.read("ball.json.progress"));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->ball, begun().ball);
  EXPECT_EQ(back->windings.r25_ohm, begun().windings.r25_ohm);
  EXPECT_EQ(back->next_step, 3u);
  ASSERT_EQ(back->runs.size(), 2u);
  EXPECT_TRUE(back->runs[0].began_at_rest);
  EXPECT_FALSE(back->runs[1].began_at_rest);
  ASSERT_EQ(back->runs[0].samples.size(), 2u);
  EXPECT_EQ(back->runs[0].samples[1].current_a, sample(3.0).current_a);
  EXPECT_EQ(back->runs[0].samples[1].sensor_c, 25.1);
  EXPECT_EQ(back->runs[1].samples[0].sensor_c, std::nullopt);

  const HeatProgressFile again(path, *back);
  EXPECT_EQ(read_progress(folder.read("ball.json.progress"))->next_step, 3u);
}

TEST(HeatProgress, ALineThatWasCutOffIsLeftOut) {
  TemporaryFolder folder;
  HeatProgressFile file(folder.path("p"), begun());
  file.add(sample(1.5), true, 0, 0);
  file.add(sample(3.0), true, 0, 1);
  std::string text = folder.read("p");
  EXPECT_EQ(read_progress(text)->next_step, 2u);
  std::string with_nul = text;
  with_nul.insert(with_nul.size() - 1, 1, '\0');
  EXPECT_EQ(read_progress(with_nul)->next_step, 1u) << "a NUL ends no line";
  with_nul.insert(with_nul.find('\n'), 1, '\0');
  EXPECT_FALSE(read_progress(with_nul));
  text.resize(text.size() - 20);
  ASSERT_TRUE(read_progress(text));
  EXPECT_EQ(read_progress(text)->next_step, 1u);
  for (const char* damaged : {"", "{}", "not JSON", "{\"hedgehog_heating\":2}", "[]\n[]"})
    EXPECT_FALSE(read_progress(damaged)) << damaged;
}

TEST(HeatProgress, ContinuesWithTheSameBallAndAmbientOnly) {
  EXPECT_EQ(incompatible(begun(), ball(), shown(40.0)), "") << "it is still warm";
  protocol::Description other = ball();
  other.name = "ball-8";
  EXPECT_THAT(incompatible(begun(), other, shown(25.0)), HasSubstr("another ball"));
  other = ball();
  other.coils.r25_ohm[1] = 0.47;
  EXPECT_THAT(incompatible(begun(), other, shown(25.0)), HasSubstr("another device file"));
  EXPECT_THAT(incompatible(begun(), ball(), shown(20.0)), HasSubstr("4.5 K cooler"));
}

TEST(HeatProgress, AnInterruptedPhaseRestarts) {
  const auto plan = model::heating_plan();
  EXPECT_EQ(resumed_step(plan, 0), 0u);
  EXPECT_EQ(resumed_step(plan, plan.size()), plan.size());
  for (std::size_t next = 1; next < plan.size(); ++next) {
    const std::size_t step = resumed_step(plan, next);
    ASSERT_LE(step, next);
    ASSERT_EQ(plan[step].phase, plan[next].phase);
    ASSERT_TRUE(step == 0 || plan[step - 1].phase != plan[step].phase);
  }
}

}  // namespace
}  // namespace hedgehog::client

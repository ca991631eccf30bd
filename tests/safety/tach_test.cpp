// SPDX-License-Identifier: MIT
// Cooling by the fan is credited by its tachometer, and only as far as the reading is plausible.
#include <algorithm>
#include <vector>

#include "daemon/device/simulator/simulator_error.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

void set_errors(rig::Rig& rig, const std::vector<device::SimulatorError>& errors) {
  device::SimulatorSettings settings = rig.board().settings();
  std::copy(errors.begin(), errors.end(), settings.errors.error.begin());
  settings.errors.count = static_cast<std::uint8_t>(errors.size());
  ++settings.errors.generation;
  rig.board().apply(settings);
}

device::SimulatorError tach_gain(double value) {
  return {device::SimulatorErrorKind::kTachGain, 0, value, 0.0};
}

/// A ball at 45 C, so that the fan runs.
rig::RigOptions warm() {
  rig::RigOptions options;
  options.board.start_c = 45.0;
  options.control.start.winding_c.fill(45.0);
  options.control.start.core_c = 45.0;
  return options;
}

/// The core estimate after a minute, with the tachometer's reading multiplied by `gain`.
double estimated_core_c(double gain) {
  rig::Rig rig(warm());
  rig.run_until_armed();
  set_errors(rig, {tach_gain(gain)});
  rig.run_s(60.0);
  EXPECT_EQ(rig.snapshot().fan_cooling, gain == 1.0) << gain;
  return rig.controller().thermal().nodes.core_c;
}

TEST(Tach, AnImpossibleReadingCreditsNoCooling) {
  const double cooled_c = estimated_core_c(1.0);
  EXPECT_GT(estimated_core_c(2.0), cooled_c + 0.5);
  EXPECT_GT(estimated_core_c(0.5), cooled_c + 0.5);
}

TEST(Tach, WithoutTelemetryNoFanIsCredited) {
  rig::Rig rig(warm());
  rig.run_s(5.0);
  ASSERT_TRUE(rig.snapshot().fan_cooling);
  rig.drop_telemetry(1000);
  rig.run(120);
  EXPECT_FALSE(rig.snapshot().fan_cooling);
}

// 15 A until the fan would be needed, but it does not turn.
TEST(Tach, ThatReadsTwiceAsMuchHidesNoHeat) {
  rig::Rig rig;
  rig.run_until_armed();
  set_errors(rig, {tach_gain(2.0), {device::SimulatorErrorKind::kCoolingGain, 0, 0.4, 0.0}});
  double hottest = 0.0;
  const auto effect = rig.start(rig::hold({0, 1, 0}, 15.0));
  for (int second = 0; second < 300; ++second) {
    rig.update(effect, rig::hold({0, 1, 0}, 15.0));
    rig.run(1000);
    hottest = std::max(hottest, rig.plant().hottest_winding_c());
  }
  EXPECT_LT(hottest, 70.0);
  EXPECT_FALSE(rig.snapshot().fan_works);
}

}  // namespace
}  // namespace hedgehog::safety

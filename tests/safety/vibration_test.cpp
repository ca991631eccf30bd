// SPDX-License-Identifier: MIT
// A vibration is delivered as requested, at any frequency: no check takes its changing currents and
// voltages for a fault, and small measurement errors do not change the current.
#include <cmath>
#include <tuple>

#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using device::FrontEndKind;
using VibrationCase = std::tuple<FrontEndKind, double, double>;

class EachVibration : public ::testing::TestWithParam<VibrationCase> {};

TEST_P(EachVibration, IsDeliveredWithinFivePercent) {
  const auto [front_end, frequency_hz, peak_a] = GetParam();
  rig::RigOptions options;
  options.board.front_end.kind = front_end;
  rig::Rig rig(options);
  rig.run_until_armed();
  model::EffectSpec spec = rig::hold({1, 0, 0}, peak_a);
  spec.method = model::EffectMethod::kVibrate;
  spec.waveform = model::Waveform::kSine;
  spec.frequency_hz = frequency_hz;
  rig.start(spec);
  rig.run(100);
  double requested_sum = 0.0;
  double measured_sum = 0.0;
  constexpr int kTicks = 3000;
  for (int i = 0; i < kTicks; ++i) {
    rig.tick();
    const double limited_a = rig.snapshot().limited_a.x;
    const double flowing_a = rig.plant().current_a().x;
    requested_sum += limited_a * limited_a;
    measured_sum += flowing_a * flowing_a;
  }
  EXPECT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
  const double requested_a = std::sqrt(requested_sum / kTicks);
  // It swings between zero and its peak.
  EXPECT_NEAR(requested_a, peak_a * std::sqrt(3.0 / 8.0), 0.02 * peak_a);
  EXPECT_NEAR(std::sqrt(measured_sum / kTicks), requested_a, 0.05 * requested_a);
}

std::string vibration_name(const ::testing::TestParamInfo<VibrationCase>& info) {
  const auto [front_end, frequency_hz, peak_a] = info.param;
  return std::string(device::name(front_end)) + "_" + std::to_string(std::lround(frequency_hz)) +
         "_hz_" + std::to_string(std::lround(peak_a)) + "_a";
}

INSTANTIATE_TEST_SUITE_P(FrontEnds, EachVibration,
                         ::testing::Combine(::testing::Values(FrontEndKind::kInLine,
                                                              FrontEndKind::kDriverCs),
                                            ::testing::Values(2.0, 10.0, 60.0, 125.0, 200.0, 250.0),
                                            ::testing::Values(2.0, 5.0)),
                         vibration_name);

}  // namespace
}  // namespace hedgehog::safety

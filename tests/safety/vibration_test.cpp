// SPDX-License-Identifier: MIT
// A vibration is delivered as requested, at any frequency: no check takes its changing currents and
// voltages for a fault, and small measurement errors do not change the current.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using device::FrontEndKind;
struct RequestedVibration {
  FrontEndKind front_end = FrontEndKind::kInLine;
  int winding = 0;
  double frequency_hz = 60.0;
  double peak_a = 5.0;
};

/// RMS current of a vibration that lasts for 3 s, as a share of the requested one; the largest
/// current in its last two seconds.
struct Delivered {
  double share = 0.0;
  double max_a = 0.0;
};

Delivered deliver(const RequestedVibration& vibration) {
  rig::RigOptions options;
  options.board.front_end.kind = vibration.front_end;
  rig::Rig rig(options);
  rig.run_until_armed();
  model::Vec3 along;
  along[vibration.winding] = 1.0;
  model::EffectSpec spec = rig::hold(along, vibration.peak_a);
  spec.method = model::EffectMethod::kVibrate;
  spec.waveform = model::Waveform::kSine;
  spec.frequency_hz = vibration.frequency_hz;
  rig.start(spec);
  rig.run(100);
  double sum_a2 = 0.0;
  Delivered delivered;
  constexpr int kTicks = 3000;
  for (int i = 0; i < kTicks; ++i) {
    rig.tick();
    const double flowing_a = rig.plant().current_a()[vibration.winding];
    sum_a2 += flowing_a * flowing_a;
    if (i >= 1000) delivered.max_a = std::max(delivered.max_a, std::abs(flowing_a));
  }
  EXPECT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
  // It swings between zero and its peak.
  const double requested_a = vibration.peak_a * std::sqrt(3.0 / 8.0);
  delivered.share = std::sqrt(sum_a2 / kTicks) / requested_a;
  return delivered;
}

using VibrationCase = std::tuple<FrontEndKind, int, double, double>;

class EachVibration : public ::testing::TestWithParam<VibrationCase> {};

TEST_P(EachVibration, IsDeliveredWithinFivePercent) {
  const auto [front_end, winding, frequency_hz, peak_a] = GetParam();
  EXPECT_NEAR(deliver({front_end, winding, frequency_hz, peak_a}).share, 1.0, 0.05);
}

std::string vibration_name(const ::testing::TestParamInfo<VibrationCase>& info) {
  const auto [front_end, winding, frequency_hz, peak_a] = info.param;
  return std::string(device::name(front_end)) + "_" + "xyz"[winding] + "_" +
         std::to_string(std::lround(frequency_hz)) + "_hz_" + std::to_string(std::lround(peak_a)) +
         "_a";
}

INSTANTIATE_TEST_SUITE_P(InLine, EachVibration,
                         ::testing::Combine(::testing::Values(FrontEndKind::kInLine),
                                            ::testing::Values(0, 1, 2),
                                            ::testing::Values(2.0, 10.0, 60.0, 125.0, 200.0, 250.0),
                                            ::testing::Values(2.0, 5.0, 10.0)),
                         vibration_name);
INSTANTIATE_TEST_SUITE_P(InLineAtFullCurrent, EachVibration,
                         ::testing::Combine(::testing::Values(FrontEndKind::kInLine),
                                            ::testing::Values(0, 1, 2),
                                            ::testing::Values(2.0, 10.0, 60.0, 125.0),
                                            ::testing::Values(15.0)),
                         vibration_name);
INSTANTIATE_TEST_SUITE_P(DriverCs, EachVibration,
                         ::testing::Combine(::testing::Values(FrontEndKind::kDriverCs),
                                            ::testing::Values(0, 1, 2),
                                            ::testing::Values(2.0, 10.0, 60.0, 125.0, 200.0, 250.0),
                                            ::testing::Values(2.0, 5.0)),
                         vibration_name);
INSTANTIATE_TEST_SUITE_P(DriverCsSlow, EachVibration,
                         ::testing::Combine(::testing::Values(FrontEndKind::kDriverCs),
                                            ::testing::Values(0, 1, 2),
                                            ::testing::Values(2.0, 10.0),
                                            ::testing::Values(10.0, 15.0)),
                         vibration_name);

// A swing of 7.5 A at 250 Hz needs 18 V across 1.5 mH and 0.45 ohm.
TEST(Vibration, ByFifteenAmpereAboveTwoHundredHertzIsLimitedByTheSupply) {
  for (const double frequency_hz : {200.0, 250.0}) {
    const double share = deliver({.frequency_hz = frequency_hz, .peak_a = 15.0}).share;
    EXPECT_GT(share, 0.84);
    EXPECT_LT(share, 0.95);
  }
}

// A sensor without sign gives no V/I in a fast vibration.
TEST(Vibration, ThatCannotBeMeasuredIsHeldToFiveAmpere) {
  for (const double frequency_hz : {60.0, 125.0, 200.0, 250.0}) {
    const Delivered delivered = deliver({FrontEndKind::kDriverCs, 1, frequency_hz, 15.0});
    EXPECT_GT(delivered.max_a, 4.0);
    EXPECT_LT(delivered.max_a, 5.5);
  }
}

}  // namespace
}  // namespace hedgehog::safety

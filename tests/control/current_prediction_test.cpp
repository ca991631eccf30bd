// SPDX-License-Identifier: MIT
// The winding currents that the next set-point's boost is computed from, against those of the
// plant.
#include "daemon/control/current_prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

const model::Vec3 kX{1, 0, 0};
const model::Vec3 kY{0, 1, 0};

/// Minimum and maximum current of winding 0, in the direction of the first pulse, while a second
/// one plays that begins `gap` ticks after the end of one along that winding. `current_a` < 0: both
/// in the opposite direction.
struct Extremes {
  double min_a = 0.0;
  double max_a = 0.0;
};
Extremes of_second_pulse(const model::Vec3& second, double current_a, model::Tick gap,
                         double freewheel_v) {
  const double sign = std::copysign(1.0, current_a);
  rig::RigOptions options;
  options.board.front_end.kind = device::FrontEndKind::kIdeal;
  options.board.plant.freewheel_v = freewheel_v;
  rig::Rig rig(options);
  rig.run_until_armed();
  const EffectId first = rig.start(rig::pulse(sign * kX, std::abs(current_a), 60));
  rig.tick();
  rig.run_until([&] { return !rig.playing(first); }, 100);
  rig.run(gap);
  rig.start(rig::pulse(sign * second, std::abs(current_a), 60));
  Extremes found;
  for (int tick = 0; tick < 40; ++tick) {
    rig.tick();
    found.min_a = std::min(found.min_a, sign * rig.plant().current_a().x);
    if (tick > 2) found.max_a = std::max(found.max_a, sign * rig.plant().current_a().x);
  }
  return found;
}

// Minimum and maximum voltage that opposes a current while the bridges sleep: of a diode, and of
// the supply behind two.
constexpr double kDiodeV = 0.8;
constexpr double kSupplyV = 13.6;

TEST(CurrentPrediction, ACurrentThatHasEndedIsNotCounteracted) {
  for (const double current_a : {5.0, -12.0})
    for (model::Tick gap = 0; gap <= 25; ++gap)
      EXPECT_GT(of_second_pulse(kY, current_a, gap, kDiodeV).min_a, -0.1)
          << current_a << " A, " << gap << " ms after the pulse before";
}

TEST(CurrentPrediction, APulseAfterAnotherDoesNotOvershoot) {
  for (const double freewheel_v : {kDiodeV, kSupplyV})
    for (const double current_a : {5.0, -12.0})
      for (model::Tick gap = 0; gap <= 25; ++gap)
        EXPECT_LT(of_second_pulse(kX, current_a, gap, freewheel_v).max_a,
                  1.02 * std::abs(current_a))
            << current_a << " A, " << gap << " ms after the pulse before, " << freewheel_v << " V";
}

}  // namespace
}  // namespace hedgehog::control

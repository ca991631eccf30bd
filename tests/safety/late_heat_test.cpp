// SPDX-License-Identifier: MIT
// Heat while control is late: debounce times and the thermal estimate follow the clock, not the
// number of steps.
#include <algorithm>
#include <array>
#include <cstddef>

#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;

// Control runs in every second, tenth or nineteenth tick only; the link holds the set-point.
class LateAndHot : public ::testing::TestWithParam<int> {};

TEST_P(LateAndHot, TheWatchdogStillTripsAtSeventy) {
  // With so few readings the noise makes a difference of 3 K: another part of it each time.
  std::array<double, 11> tripped_c{};
  for (std::size_t i = 0; i < tripped_c.size(); ++i) {
    rig::Rig rig(without_limiter());
    rig.run_until_armed();
    rig.run(static_cast<model::Tick>(7 * i));
    rig.start(rig::hold({0, 1, 0}, 15.0, 60'000));
    rig.run(10);
    while (rig.now() < 60'000 && rig.controller().state() == control::State::kArmed) {
      rig.skip_control(GetParam());
      rig.tick();
    }
    expect_tripped(rig, Reason::kOverheated);
    tripped_c[i] = rig.plant().hottest_winding_c();
    EXPECT_GT(tripped_c[i], 66.0);
    EXPECT_LT(tripped_c[i], 70.6);
  }
  // With few readings the estimate is less certain, and trips slightly earlier.
  std::nth_element(tripped_c.begin(), tripped_c.begin() + tripped_c.size() / 2, tripped_c.end());
  EXPECT_GT(tripped_c[tripped_c.size() / 2], 68.5);
}

TEST_P(LateAndHot, TheEstimateFollowsTheBall) {
  // Tests the timing: with so few readings the noise of a real board would dominate.
  rig::RigOptions options;
  options.board.front_end.kind = device::FrontEndKind::kIdeal;
  rig::Rig rig(options);
  rig.run_until_armed();
  rig.start(rig::hold({1, 1, 1}, 9.0, 60'000));
  rig.run(10);
  double worst_core_k = 0.0;
  double worst_winding_k = 0.0;
  while (rig.now() < 45'000) {
    rig.skip_control(GetParam());
    rig.tick();
    const model::ThermalState known = rig.controller().thermal().nodes;
    const model::ThermalState real = rig.plant().heat();
    worst_core_k = std::max(worst_core_k, std::abs(known.core_c - real.core_c));
    for (std::size_t coil = 0; coil < model::kCoils; ++coil) {
      const double error_k = known.winding_c[coil] - real.winding_c[coil];
      worst_winding_k = std::max(worst_winding_k, std::abs(error_k));
    }
  }
  EXPECT_EQ(name(rig.controller().state()), "armed");
  EXPECT_GT(rig.plant().heat().core_c, 28.0);
  // A current rounded to 1 mA may give a permanent error of 0.02 K, from which the core is
  // estimated.
  EXPECT_LT(worst_core_k, 1.0);
  EXPECT_LT(worst_winding_k, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Gap, LateAndHot, ::testing::Values(1, 9, 18));

}  // namespace
}  // namespace hedgehog::safety

// SPDX-License-Identifier: MIT
// The skin of a ball without a thermometer under it: with the estimate it is held at 43 C after ten
// minutes and always below 48 C, at every ambient temperature and in every hand, while a ball that
// matches its file still gets 5 A.
#include <algorithm>
#include <cmath>

#include "tests/rig/hours.h"
#include "tests/rig/sanitized.h"
#include "tests/rig/thermal_ball.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using model::Vec3;

constexpr double kOpen = 1.0;
constexpr double kClosed = 2.0;
/// Cooling with the fan no better than without.
constexpr double kNoFan = 5.0 / 1.8;
const Vec3 kOneCoil{0, 1, 0};
const Vec3 kAllCoils{1, 1, 1};

struct Place {
  const char* name;
  double ambient_c;
  double hand;
  Vec3 direction;
};

rig::RigOptions ball_in(const Place& place) {
  rig::RigOptions options;
  options.board.plant.core_to_ambient_fan_k_w *= place.hand;
  if (place.hand == kClosed) options.board.plant.core_to_ambient_still_k_w *= place.hand;
  options.board.ambient_c = options.board.start_c = place.ambient_c;
  options.control.start.winding_c.fill(place.ambient_c);
  options.control.start.core_c = options.control.start_ambient_c = place.ambient_c;
  return options;
}

class SkinAtFifteenAmpere : public ::testing::TestWithParam<Place> {};

TEST_P(SkinAtFifteenAmpere, IsLimitedToFortyThree) {
  rig::Rig rig(ball_in(GetParam()));
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold(GetParam().direction, 15.0));
  rig::HourResult result;
  for (int second = 0; second < 1200; second += 2) {
    rig.update(effect, rig::hold(GetParam().direction, 15.0));
    rig.run(2000);
    rig.clear_events();
    EXPECT_EQ(rig::follow_skin(result, rig.plant().skin_c(), second), "");
    EXPECT_LE(rig.plant().skin_c(), rig.snapshot().skin.bound_c) << second << " s";
  }
  EXPECT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
  EXPECT_GT(result.skin_c, 40.0) << "the reduction was never needed, so nothing was tested";
  EXPECT_TRUE(rig.controller().derating());
  EXPECT_GT(rig.current_a(), 2.0) << "reduced, not cut off";
}

INSTANTIATE_TEST_SUITE_P(Places, SkinAtFifteenAmpere,
                         ::testing::Values(Place{"room_25", 25.0, kOpen, kAllCoils},
                                           Place{"room_32_closed", 32.0, kClosed, kAllCoils},
                                           Place{"room_18_closed", 18.0, kClosed, kOneCoil},
                                           Place{"room_32_no_fan", 32.0, kNoFan, kOneCoil}),
                         [](const auto& place) { return place.param.name; });

TEST(SkinAtFiveAmpere, InAClosedHandIsLimitedToFortyThree) {
  rig::Rig rig(ball_in({"", 25.0, kClosed, kAllCoils}));
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold(kAllCoils, 5.0));
  rig::HourResult result;
  for (int second = 0; second < 2400; second += 5) {
    rig.update(effect, rig::hold(kAllCoils, 5.0));
    rig.run(5000);
    rig.clear_events();
    EXPECT_EQ(rig::follow_skin(result, rig.plant().skin_c(), second), "");
  }
  EXPECT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
  EXPECT_LT(rig.current_a(), 4.5);
  EXPECT_GT(rig.current_a(), 3.0);
}

/// A ball of the family, in closed loop with steps of 20 ms.
rig::ThermalBallOptions family(std::uint64_t seed, int thermistors, double hand) {
  device::FrontEndChoice front_end;
  front_end.thermistors = thermistors;
  rig::ThermalBallOptions options = rig::family_ball(seed, front_end, 0.2);
  options.skin_limits = true;
  options.board.plant.core_to_ambient_fan_k_w *= hand;
  if (hand == kClosed) options.board.plant.core_to_ambient_still_k_w *= hand;
  return options;
}

// 3 A for 18 minutes and then a burst at full demand, repeatedly: the heat of the windings reaches
// the shell when it is already warm.
TEST(SkinOfTheFamily, IsLimitedWhenABurstFollowsOnAWarmBall) {
  rig::HourResult all;
  for (std::uint64_t seed = 1; seed <= repetitions(24U); ++seed) {
    const double hand = std::array{kOpen, kClosed, kNoFan}[seed % 3];
    rig::ThermalBall ball(family(40'000 + seed, seed % 2 == 0 ? 1 : 3, hand));
    for (int i = 0; i < 180'000; ++i) {
      const double now_s = i * rig::ThermalBall::kStepS;
      const bool burst = std::fmod(now_s, 1500.0) > 1100.0;
      ball.step(burst ? Vec3{8.66, 8.66, 8.66} : Vec3{0, 3, 0});
      ASSERT_EQ(rig::follow_skin(all, ball.plant().skin_c(), now_s), "")
          << "seed " << seed << ", hand " << hand;
    }
    EXPECT_FALSE(ball.stop().any()) << words(ball.stop()) << ", seed " << seed;
  }
  EXPECT_GT(all.held_skin_c, 41.0);
}

TEST(SkinOfTheFamily, IsLimitedInAnHourOfRandomPlayInAClosedHand) {
  for (std::uint64_t seed = 1; seed <= repetitions(12U); ++seed)
    EXPECT_EQ(rig::thermal_hour(50'000 + seed, 3600.0, {}, 0.2, kClosed).failure, "") << seed;
}

TEST(SkinLimit, AllowsFiveAmpereForHoursOnAMatchingBall) {
  for (const int thermistors : {3, 1}) {
    rig::ThermalBallOptions options;
    options.skin_limits = true;
    options.board.front_end.thermistors = thermistors;
    options.board.ambient_c = options.board.start_c = 25.0;
    rig::ThermalBall ball(options);
    for (int i = 0; i < 4 * 180'000; ++i) {
      ball.step({5, 0, 0});
      ASSERT_FALSE(ball.reduced()) << i * rig::ThermalBall::kStepS << " s";
    }
    EXPECT_GT(ball.plant().skin_c(), 41.0);
  }
}

}  // namespace
}  // namespace hedgehog::safety

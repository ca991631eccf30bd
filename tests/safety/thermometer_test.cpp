// SPDX-License-Identifier: MIT
// The second thermometer: under the skin it derates from 38 C on, to zero at 43 C, and trips at 48
// C; beside the coil sensor it must agree with it; once configured, it must not fall silent.
#include <cmath>
#include <limits>

#include "model/limit/shell_limit.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;
using device::ThermometerRole;

/// A ball with a second thermometer that reports twice per second.
struct Ball {
  rig::Rig rig;
  double reading_c = 25.0;
  bool responds = true;

  explicit Ball(ThermometerRole role, double start_c = 25.0) : rig(options(role, start_c)) {}

  static rig::RigOptions options(ThermometerRole role, double start_c) {
    rig::RigOptions made;
    made.control.thermometer = role;
    made.board.start_c = start_c;
    return made;
  }

  /// `true_c` returns the probe's temperature and is called each tick.
  template <class TrueTemperature>
  void run(model::Tick ticks, TrueTemperature true_c) {
    for (model::Tick i = 0; i < ticks; ++i) {
      reading_c = true_c();
      if (responds && rig.now() % 500 == 0) rig.set_thermometer(reading_c);
      rig.tick();
    }
  }
  void run(model::Tick ticks, double celsius) {
    run(
        ticks, [&] { return celsius; });
  }
  void arm_at(double celsius) {
    rig.set_thermometer(celsius);
    run(600, celsius);
    ASSERT_EQ(name(rig.controller().state()), "armed") << name(rig.snapshot().arming_blocker);
  }
  bool armed() const { return rig.controller().state() == control::State::kArmed; }
};

/// The skin of a badly insulated ball: it follows the core, at 70 % of the difference to ambient,
/// with a time constant of a minute.
struct Skin {
  double celsius = 25.0;
  double step(const model::Plant& plant) {
    const double goal = 25.0 + 0.7 * (plant.heat().core_c - 25.0);
    celsius += (goal - celsius) * 1e-3 / 60.0;
    return celsius;
  }
};

TEST(Shell, HalfAnHourOfFullDemandIsReducedAndNeverReachesFortyThree) {
  Ball ball(ThermometerRole::kShell);
  ball.arm_at(25.0);
  Skin skin;
  double hottest = 0.0;
  double hottest_held = 0.0;
  for (int second = 0; second < 1800; ++second) {
    ball.rig.start(rig::hold({1, 1, 1}, 15.0, 1001));
    ball.run(1000, [&] { return skin.step(ball.rig.plant()); });
    hottest = std::max(hottest, skin.celsius);
    if (second > 600) hottest_held = std::max(hottest_held, skin.celsius);
  }
  ::testing::Test::RecordProperty("hottest_mc", static_cast<int>(1000 * hottest));
  EXPECT_TRUE(ball.armed()) << name(ball.rig.controller().reason());
  EXPECT_GT(hottest_held, 42.0) << "the reduction was never needed, so nothing was tested";
  EXPECT_LT(hottest_held, 43.0);
  EXPECT_LT(hottest, 43.0);
  EXPECT_TRUE(ball.rig.controller().derating());
}

TEST(Shell, ReducesFromThirtyEightOn) {
  Ball ball(ThermometerRole::kShell);
  ball.arm_at(37.9);
  ball.rig.start(rig::hold({1, 0, 0}, 10.0));
  ball.run(300, 37.9);
  EXPECT_NEAR(ball.rig.current_a(), 10.0, 0.1);
  EXPECT_FALSE(ball.rig.controller().derating());
  ball.run(1000, 42.8);
  EXPECT_TRUE(ball.rig.snapshot().thermometer_known);
  EXPECT_EQ(ball.rig.snapshot().thermometer_c, 42.8);
  // The limit accounts for the heat of this second of 10 A that will still reach the skin.
  EXPECT_LT(ball.rig.current_a(), 5.0);
  EXPECT_GT(ball.rig.current_a(), 2.0);
  EXPECT_TRUE(ball.rig.controller().derating());
  EXPECT_TRUE(ball.armed());
}

TEST(Shell, TripsAtFortyEight) {
  Ball ball(ThermometerRole::kShell);
  ball.arm_at(30.0);
  ball.rig.start(rig::hold({1, 0, 0}, 5.0));
  ball.run(500, 30.0);
  ASSERT_GT(ball.rig.current_a(), 4.9);
  ball.rig.set_thermometer(48.0);
  ball.rig.tick();
  ball.run(50, 48.0);
  EXPECT_LT(ball.rig.current_a(), kZeroA) << "reduced to nothing at once";
  EXPECT_TRUE(ball.armed());
  ball.run(1440, 48.0);
  EXPECT_TRUE(ball.armed());
  expect_zero(ball.rig, 20);
  expect_tripped(ball.rig, Reason::kShellHot);
  // Armed again only when the skin is cool enough to be held.
  ball.run(1000, 43.5);
  ball.rig.arm();
  ball.run(400, 43.5);
  EXPECT_EQ(name(ball.rig.snapshot().arming_blocker), "shell_hot");
  EXPECT_FALSE(ball.armed());
  ball.run(1000, 42.5);
  ball.rig.arm();
  ball.run(400, 42.5);
  EXPECT_TRUE(ball.armed());
}

TEST(Shell, OneWrongReadingDoesNotTrip) {
  Ball ball(ThermometerRole::kShell);
  ball.arm_at(30.0);
  ball.run(500, 90.0);
  ball.run(2000, 30.0);
  EXPECT_TRUE(ball.armed());
}

TEST(Coil, AgreesWhileDrivenHardWithASlowProbe) {
  for (const double lag_s : {1.0, 10.0, 40.0}) {
    Ball ball(ThermometerRole::kCoil);
    ball.arm_at(25.0);
    double probe = 25.0;
    for (int second = 0; second < 400; ++second) {
      // Half a minute on, half a minute off: the worst case for lags.
      if (second % 60 < 30) ball.rig.start(rig::hold({1, 0, 0}, 15.0, 1001));
      ball.run(1000, [&] {
        const double winding = ball.rig.plant().heat().winding_c[0];
        return probe += (winding - probe) * 1e-3 / lag_s;
      });
    }
    EXPECT_TRUE(ball.armed()) << lag_s << ": " << name(ball.rig.controller().reason());
  }
}

TEST(Coil, DisagreementEitherWayIsAFault) {
  for (const double off : {-12.0, 12.0}) {
    Ball ball(ThermometerRole::kCoil);
    ball.arm_at(25.0);
    ball.rig.start(rig::hold({1, 0, 0}, 3.0));
    ball.run(4000, 25.0 + off);
    EXPECT_TRUE(ball.armed()) << "5 s of it";
    ball.run(1600, 25.0 + off);
    expect_tripped(ball.rig, Reason::kThermometerDisagrees);
    EXPECT_TRUE(asleep(ball.rig));
    ball.rig.run(kDecay);
    EXPECT_LT(ball.rig.current_a(), kZeroA);
    ball.rig.arm();
    ball.run(400, 25.0 + off);
    EXPECT_FALSE(ball.armed());
  }
}

TEST(Coil, SeventyByTheProbeAloneIsTooHot) {
  Ball ball(ThermometerRole::kCoil);
  ball.arm_at(25.0);
  ball.run(2100, 71.0);
  expect_tripped(ball.rig, Reason::kOverheated);
}

class Silence : public ::testing::TestWithParam<ThermometerRole> {};

TEST_P(Silence, OfFiveSecondsIsAFault) {
  Ball ball(GetParam());
  ball.arm_at(25.0);
  ball.responds = false;
  ball.rig.start(rig::hold({1, 0, 0}, 5.0));
  ball.run(4000, 25.0);
  EXPECT_GT(ball.rig.current_a(), 4.9);
  ball.run(1000, 25.0);
  expect_tripped(ball.rig, Reason::kThermometerLost);
  expect_zero(ball.rig, 5);
}

TEST_P(Silence, FromTheStartBlocksArming) {
  Ball ball(GetParam());
  ball.responds = false;
  ball.run(2000, 25.0);
  EXPECT_EQ(name(ball.rig.controller().state()), "disarmed");
  EXPECT_EQ(name(ball.rig.snapshot().arming_blocker), "thermometer_lost");
  ball.rig.set_thermometer(std::numeric_limits<double>::quiet_NaN());
  ball.run(400, 25.0);
  EXPECT_EQ(name(ball.rig.snapshot().arming_blocker), "thermometer_lost");
  ball.responds = true;
  ball.run(1000, 25.0);
  EXPECT_TRUE(ball.armed()) << "and then arms as it would have at the start";
}

INSTANTIATE_TEST_SUITE_P(EachRole, Silence,
                         ::testing::Values(ThermometerRole::kCoil, ThermometerRole::kShell),
                         [](const auto& role) {
                           return role.param == ThermometerRole::kCoil ? "coil" : "shell";
                         });

TEST(NoThermometer, NothingIsExpectedOfIt) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.set_thermometer(90.0);
  rig.run(10'000);
  EXPECT_FALSE(rig.snapshot().thermometer_known);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

// A probe overrides the estimate, in both directions.
TEST(Shell, AProbeOnAnInsulatingShellAllowsMoreCurrent) {
  Ball ball(ThermometerRole::kShell, 60.0);
  ball.arm_at(30.0);
  EXPECT_LT(model::shell_allowed_current({}, ball.rig.snapshot().skin.estimate.celsius()).value,
            0.1);
  ball.rig.start(rig::hold({1, 0, 0}, 5.0));
  ball.run(300, 30.0);
  EXPECT_NEAR(ball.rig.current_a(), 5.0, 0.1);
}

TEST(Shell, AProbeThatHasFallenSilentDoesNotOverrideTheEstimate) {
  Ball ball(ThermometerRole::kShell, 60.0);
  ball.arm_at(30.0);
  ball.rig.start(rig::hold({1, 0, 0}, 5.0));
  ball.run(300, 30.0);
  ball.responds = false;
  ball.run(2000, 30.0);
  EXPECT_NEAR(ball.rig.current_a(), 5.0, 0.1);
  ball.run(1500, 30.0);
  EXPECT_TRUE(ball.armed()) << "5 s of it trip";
  EXPECT_LT(ball.rig.current_a(), kZeroA);
}

TEST(Shell, WithoutAnyReadingOfTheProbeNothingFlows) {
  Ball ball(ThermometerRole::kShell);
  ball.run(1000, [&] { return std::nan(""); });
  EXPECT_EQ(ball.rig.snapshot().limit_a, 0.0);
}

}  // namespace
}  // namespace hedgehog::safety

// SPDX-License-Identifier: MIT
// A ball that tripped because the resistance of a winding fell is armed again. After a rest its
// resistance is compared with the thermistor: a healthy ball plays; a faulty one trips again before
// its winding has warmed by more than that comparison requires.
#include <tuple>

#include "tests/rig/thermal_ball.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using device::SimulatorErrorKind;

constexpr int kY = 1;
constexpr double kDemandA = 12.0;
constexpr double kRestS = 720.0;
/// Maximum warming of a winding before its resistance has been compared, K, times the tolerance of
/// its capacity.
constexpr double kComparedK = 3.0 * 1.2;
/// Minimum warming of a winding, K, when the demanded current is delivered.
constexpr double kPlayedK = 20.0;

device::SimulatorErrorList errors_of(const device::SimulatorError& error, std::uint8_t generation) {
  device::SimulatorErrorList errors;
  errors.generation = generation;
  errors.error[errors.count++] = error;
  return errors;
}

struct Electronics {
  device::FrontEndKind kind;
  int thermistors;
};

std::ostream& operator<<(std::ostream& out, const Electronics& one) {
  return out << name(one.kind) << " " << one.thermistors;
}

using HealthyAgainCase = std::tuple<Electronics, device::SimulatorError>;

/// A ball that has tripped because its resistance fell.
class HealthyAgain : public ::testing::TestWithParam<HealthyAgainCase> {
 protected:
  HealthyAgain() : ball(options()) {
    const auto& error = std::get<1>(GetParam());
    held[error.coil] = kDemandA;
    bool broken = false;
    for (int i = 0; i < 30'000 && !ball.stop().any(); ++i) {
      if (!broken && ball.plant().heat().winding_c[error.coil] > 45.0) {
        broken = true;
        ball.set_errors(errors_of(error, 1));
      }
      ball.step(held);
    }
  }
  static rig::ThermalBallOptions options() {
    rig::ThermalBallOptions options;
    const Electronics& one = std::get<0>(GetParam());
    options.board.front_end.kind = one.kind;
    options.board.front_end.thermistors = static_cast<std::uint8_t>(one.thermistors);
    return options;
  }
  void SetUp() override {
    ASSERT_EQ(name(ball.stop().reason), "measurements_disagree");
    ASSERT_TRUE(ball.observer().fall(std::get<1>(GetParam()).coil).certain());
  }
  void rest(double seconds) {
    for (double s = 0.0; s < seconds; s += rig::ThermalBall::kStepS) ball.step({});
  }
  /// Repeats the previous demand for at most `seconds`. Returns the maximum winding temperature, C.
  double play(double seconds) {
    double hottest_c = 0.0;
    for (double s = 0.0; s < seconds && !ball.stop().any(); s += rig::ThermalBall::kStepS) {
      ball.step(held);
      hottest_c = std::max(hottest_c, ball.plant().hottest_winding_c());
    }
    return hottest_c;
  }
  rig::ThermalBall ball;
  model::Vec3 held;
};

TEST_P(HealthyAgain, PlaysAfterARest) {
  ball.set_errors(errors_of({SimulatorErrorKind::kTachGain, 0, 1.0, 0.0}, 2));
  rest(kRestS);
  const double rested_c = ball.plant().hottest_winding_c();
  ball.rearm();
  const double hottest_c = play(300.0);
  EXPECT_LT(hottest_c, 75.0);
  EXPECT_GT(hottest_c, rested_c + kPlayedK);
  EXPECT_FALSE(ball.stop().any()) << words(ball.stop());
}

TEST_P(HealthyAgain, StillBrokenItTripsAgainAfterEveryRest) {
  for (int rests = 0; rests < 3; ++rests) {
    rest(kRestS);
    const double rested_c = ball.plant().hottest_winding_c();
    ball.rearm();
    EXPECT_LT(play(300.0), rested_c + kComparedK) << rests;
    EXPECT_EQ(name(ball.stop().reason), "measurements_disagree") << rests;
  }
}

TEST_P(HealthyAgain, WithoutARestArmingClearsNothing) {
  rest(5.0);
  ball.rearm();
  const double rested_c = ball.plant().hottest_winding_c();
  EXPECT_LT(play(300.0), rested_c + kComparedK);
  EXPECT_EQ(name(ball.stop().reason), "measurements_disagree");
}

constexpr device::SimulatorError shorted(int coil, double share, double ramp_s) {
  return {SimulatorErrorKind::kShortedTurns, static_cast<std::uint8_t>(coil), share, ramp_s};
}

INSTANTIATE_TEST_SUITE_P(
    InLine, HealthyAgain,
    ::testing::Combine(::testing::Values(Electronics{device::FrontEndKind::kInLine, 3},
                                         Electronics{device::FrontEndKind::kInLine, 1}),
                       ::testing::Values(shorted(0, 0.2, 120.0), shorted(1, 0.2, 120.0),
                                         shorted(2, 0.4, 600.0), shorted(1, 0.1, 120.0))));

INSTANTIATE_TEST_SUITE_P(
    DriverCs, HealthyAgain,
    ::testing::Combine(::testing::Values(Electronics{device::FrontEndKind::kDriverCs, 1}),
                       ::testing::Values(shorted(0, 0.2, 120.0), shorted(1, 0.2, 120.0),
                                         shorted(2, 0.4, 120.0))));

/// The same on the whole rig, with the firmware's own conversion of raw values.
class HealthyAgainOnTheRig : public ::testing::Test {
 protected:
  void SetUp() override {
    rig.run_until_armed();
    const auto effect = rig.start(rig::hold({0, 1, 0}, kDemandA));
    bool broken = false;
    for (int second = 0; second < 300 && !tripped(); ++second) {
      rig.update(effect, rig::hold({0, 1, 0}, kDemandA));
      rig.run(1000);
      if (broken || rig.plant().heat().winding_c[kY] < 45.0) continue;
      broken = true;
      rig.board().set_errors(errors_of(shorted(kY, 0.05, 60.0), 1));
    }
    ASSERT_EQ(name(rig.controller().reason()), "measurements_disagree");
  }
  bool tripped() const { return rig.controller().state() == control::State::kTripped; }
  void rearm_and_play(int seconds) {
    rig.arm();
    rig.run(100);
    ASSERT_EQ(name(rig.controller().state()), "armed");
    const auto effect = rig.start(rig::hold({0, 1, 0}, kDemandA));
    for (int second = 0; second < seconds && !tripped(); ++second) {
      rig.update(effect, rig::hold({0, 1, 0}, kDemandA));
      rig.run(1000);
    }
  }
  rig::Rig rig;
};

TEST_F(HealthyAgainOnTheRig, PlaysAfterARest) {
  rig.board().set_errors({});
  rig.run_s(kRestS);
  const double rested_c = rig.plant().hottest_winding_c();
  rearm_and_play(60);
  EXPECT_GT(rig.plant().hottest_winding_c(), rested_c + kPlayedK);
  EXPECT_FALSE(tripped()) << name(rig.controller().reason());
}

TEST_F(HealthyAgainOnTheRig, StillBrokenItTripsAgain) {
  rig.run_s(kRestS);
  const double rested_c = rig.plant().hottest_winding_c();
  rearm_and_play(60);
  EXPECT_EQ(name(rig.controller().reason()), "measurements_disagree");
  EXPECT_LT(rig.plant().hottest_winding_c(), rested_c + kComparedK);
  expect_zero(rig, 2);
}

}  // namespace
}  // namespace hedgehog::safety

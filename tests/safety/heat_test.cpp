// SPDX-License-Identifier: MIT
// Overheating: the limiter's law, and the watchdog when the limiter fails.
#include <limits>

#include "daemon/device/board_codec.h"
#include "daemon/device/simulator/simulator_settings.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;

/// Holds `current_a` along `axis` until the ball is not armed any more; returns the maximum
/// temperature.
double hottest_until_stopped(rig::Rig& rig, const model::Vec3& axis, double current_a,
                             double max_s) {
  double hottest = 0.0;
  const auto effect = rig.start(rig::hold(axis, current_a));
  for (double t = 0.0; t < max_s; t += 1.0) {
    rig.update(effect, rig::hold(axis, current_a));
    for (int i = 0; i < 1000; ++i) {
      rig.tick();
      hottest = std::max(hottest, rig.plant().hottest_winding_c());
    }
    if (rig.controller().state() != control::State::kArmed) break;
  }
  return hottest;
}

/// The ball is at `celsius`, as saved, in a much hotter environment.
void start_at(rig::RigOptions& options, double celsius, double ambient_c) {
  options.board.start_c = celsius;
  options.board.ambient_c = ambient_c;
  options.control.start.winding_c.fill(celsius);
  options.control.start.core_c = celsius;
  options.control.start_ambient_c = ambient_c;
}

class WithoutLimiter : public ::testing::TestWithParam<int> {};

TEST_P(WithoutLimiter, TheWatchdogTripsAtSeventyByTheWindingsOwnResistance) {
  rig::Rig rig(without_limiter());
  rig.run_until_armed();
  model::Vec3 axis;
  axis[GetParam()] = 1.0;
  const double hottest = hottest_until_stopped(rig, axis, 15.0, 40.0);
  EXPECT_TRUE(asleep(rig));
  EXPECT_LT(rig.current_a(), kZeroA);
  expect_tripped(rig, Reason::kOverheated);
  // 2.4 K/s during the debounce time of 50 ms, and a share of the noise of a real board.
  EXPECT_GT(hottest, 69.5);
  EXPECT_LT(hottest, 70.75);
}

INSTANTIATE_TEST_SUITE_P(EachWinding, WithoutLimiter, ::testing::Values(0, 1, 2));

TEST(TooHot, TheRawThermistorTripsWithoutAnyCurrent) {
  rig::RigOptions options;
  start_at(options, 68.0, 120.0);
  options.board.plant.sensor_noise_k = 0.0;
  rig::Rig warm(options);
  warm.run_until_armed();
  // The converter and the thermistor's curve are accurate to 0.25 K, the estimate to 0.5 K.
  ASSERT_TRUE(warm.run_until([&] { return warm.plant().sensor_c() >= 69.0; }, 60'000));
  EXPECT_EQ(name(warm.controller().state()), "armed") << name(warm.controller().reason());
  ASSERT_TRUE(warm.run_until([&] { return warm.plant().sensor_c() >= 70.3; }, 60'000) &&
              warm.run_until([&] { return warm.controller().state() == control::State::kTripped; },
                             50 + 12));
  expect_zero(warm, 2);
  expect_tripped(warm, Reason::kOverheated);
}

TEST(TooHot, ArmingWaitsUntilItIsCool) {
  rig::Rig rig(without_limiter());
  rig.run_until_armed();
  hottest_until_stopped(rig, {1, 0, 0}, 15.0, 40.0);
  expect_tripped(rig, Reason::kOverheated);
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "overheated");
  // below max(45 C, ambient + 10 K)
  ASSERT_TRUE(
      rig.run_until([&] { return rig.snapshot().arming_blocker == Reason::kNone; }, 300'000));
  EXPECT_LT(rig.plant().hottest_winding_c(), 45.5);
  EXPECT_GT(rig.plant().hottest_winding_c(), 42.0);
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

/// Any single fault of the thermistor, at full demand.
class SensorFaultWhileHot : public ::testing::TestWithParam<int> {};

TEST_P(SensorFaultWhileHot, NoWindingPassesSeventyThree) {
  model::RandomStream random(static_cast<std::uint64_t>(GetParam()) + 100);
  const auto fault = static_cast<std::uint16_t>(1 << (GetParam() % 6));
  for (int coil = 0; coil < model::kCoils; ++coil) {
    rig::RigOptions options;
    options.board = rig::random_board(random);
    options.control.start.winding_c.fill(options.board.start_c);
    options.control.start.core_c = options.board.start_c;
    rig::Rig rig(options);
    rig.run_until_armed();
    model::Vec3 along;
    along[coil] = 1.0;
    rig.start(rig::hold(along, 15.0));
    rig.run_s(random.uniform(1.0, 9.0));
    rig.set_faults(fault);
    const double hottest = hottest_until_stopped(rig, along, 15.0, 180.0);
    EXPECT_LE(hottest, 73.1) << "winding " << coil << ", fault " << fault;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, SensorFaultWhileHot, ::testing::Range(0, 12));

// All protection above the board disabled: no limiter, no watchdog at 70 C.
TEST(BoardsOwnLimits, ThermistorAboveSeventyFive) {
  rig::Rig rig(without_limiter(300.0));
  rig.run_until_armed();
  hottest_until_stopped(rig, {1, 0, 0}, 9.0, 300.0);
  EXPECT_TRUE(asleep(rig));
  EXPECT_LT(rig.current_a(), kZeroA);
  expect_tripped(rig, Reason::kBoardOverHeat);
  EXPECT_LT(rig.plant().hottest_winding_c(), 80.0);
}

TEST(BoardsOwnLimits, HeatBudgetOfAWindingWithoutThermistor) {
  rig::RigOptions options = without_limiter(300.0);
  options.board.front_end.thermistors = 1;
  rig::Rig rig(options);
  rig.run_until_armed();
  hottest_until_stopped(rig, {0, 1, 0}, 14.0, 300.0);
  EXPECT_TRUE(asleep(rig));
  EXPECT_LT(rig.current_a(), kZeroA);
  expect_tripped(rig, Reason::kBoardHeatBudget);
}

TEST(BoardsOwnLimits, OverCurrentForFiftyMilliseconds) {
  rig::RigOptions options = without_limiter();
  options.control.limits.current_a = 20.0;
  options.control.ceiling = options.control.limits;
  rig::Rig rig(options);
  rig.run_until_armed();
  rig.start(rig::hold({1, 1, 1}, 18.0));
  rig.run(3);
  expect_zero(rig, 50 + 12);
  expect_tripped(rig, Reason::kBoardOverCurrent);
}

// Limits of an earlier daemon with a tighter configuration: the board keeps them until power-up.
TEST(BoardsOwnLimits, OfAnEarlierConfigurationStayInForce) {
  rig::Rig rig;
  rig.board().receive(device::encode_limits({67.0, 5.5, 1.0}, 1));
  rig.run_until_armed();
  rig.start(rig::hold({1, 1, 0}, 15.0));
  rig.run(2000);
  EXPECT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
  EXPECT_NEAR(rig.current_a(), 5.0, 0.02);
  EXPECT_NEAR(rig.snapshot().limit_a, 5.0, 1e-6);
  EXPECT_FALSE(rig.snapshot().derating) << "it is not warm";
  model::Limits limits;
  limits.current_a = limits.continuous_a = 3.0;
  rig.command(control::SetLimits{limits});
  rig.run(300);
  EXPECT_NEAR(rig.current_a(), 3.0, 0.02);

  rig::RigOptions options;
  start_at(options, 61.0, 120.0);
  rig::Rig warm(options);
  warm.board().receive(device::encode_limits({67.0, 5.5, 1.0}, 1));
  warm.run_until_armed();
  EXPECT_TRUE(
      warm.run_until([&] { return warm.controller().state() != control::State::kArmed; }, 30'000));
  EXPECT_NEAR(warm.plant().sensor_c(), 61.75, 0.5);
  expect_tripped(warm, Reason::kOverheated);
}

TEST(ImplausibleNumber, IsZeroForThatTickAndReported) {
  rig::Rig rig;
  hold_five_ampere(rig);
  const auto bad = rig.start(rig::hold({1, 0, 0}, std::numeric_limits<double>::quiet_NaN()));
  rig.tick();
  EXPECT_LE(rig.last_command().first_duty().x, 0.0) << "nothing is pushed in that tick";
  EXPECT_EQ(norm(rig.snapshot().limited_a), 0.0);
  EXPECT_EQ(rig.count(control::EventType::kRejectedNumber), 1);
  rig.stop(bad);
  rig.run(30);
  EXPECT_EQ(name(rig.controller().state()), "armed");
  EXPECT_NEAR(rig.current_a(), 5.0, 0.05) << "the other effect never noticed";
}

TEST(ImplausibleNumber, RepeatedTrips) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, std::numeric_limits<double>::infinity()));
  rig.run(50);
  expect_zero(rig, 5);
  expect_tripped(rig, Reason::kInternal);
}

TEST(Restart, UnknownWindingsAreHeldToFiveAmpereUntilMeasured) {
  rig::RigOptions options;
  options.control.start_known = false;
  options.control.start_measured = {};
  rig::Rig rig(options);
  rig.run_until_armed();
  rig.start(rig::hold({0, 0, 1}, 15.0));
  rig.run(2);
  EXPECT_NEAR(rig.snapshot().limited_a.z, 5.0, 1e-9);
  ASSERT_TRUE(rig.run_until([&] { return norm(rig.snapshot().limited_a) > 14.9; }, 300));
  EXPECT_TRUE(rig.snapshot().thermal.measured[2]);
  EXPECT_FALSE(rig.snapshot().thermal.measured[0]) << "the undriven ones do not hold it back";
}

TEST(Restart, EachNodeStartsAtTheHotterOfSavedAndSensor) {
  rig::RigOptions options;
  options.control.start = {{50.0, 20.0, 40.0}, 45.0};
  options.board.start_c = 30.0;
  options.board.plant.sensor_noise_k = 0.0;
  rig::Rig rig(options);
  rig.run(10);
  const auto& nodes = rig.controller().thermal().nodes;
  EXPECT_NEAR(nodes.winding_c[0], 50.0, 0.2);
  EXPECT_NEAR(nodes.winding_c[1], 30.0, 0.2);
  EXPECT_NEAR(nodes.winding_c[2], 40.0, 0.2);
  EXPECT_NEAR(nodes.core_c, 45.0, 0.2);
}

// The thermistor is on winding 0 and is cold; only the saved state contains the temperature of
// winding 1.
TEST(Restart, HeatOfAWindingThatNeverMeasuredItselfPersistsToo) {
  rig::RigOptions options;
  options.control.start_measured = {};
  options.control.start = {{30.0, 66.0, 30.0}, 30.0};
  options.control.latch = Reason::kOverheated;
  options.board.start_c = 30.0;
  rig::Rig rig(options);
  rig.run(300);
  rig.arm();
  rig.run(300);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "overheated");
  ASSERT_TRUE(
      rig.run_until([&] { return rig.snapshot().arming_blocker == Reason::kNone; }, 600'000));
  EXPECT_LT(rig.snapshot().thermal.hottest_c, 46.0);
}

TEST(Restart, LatchesPersist) {
  for (const Reason latch : {Reason::kOverheated, Reason::kEmergencyStop}) {
    rig::RigOptions options;
    options.control.latch = latch;
    rig::Rig rig(options);
    rig.run(1000);
    EXPECT_EQ(name(rig.controller().reason()), name(latch));
    EXPECT_NE(name(rig.controller().state()), "armed") << "arm_at_start does not clear a latch";
    rig.start(rig::hold({1, 0, 0}, 5.0));
    rig.run(50);
    EXPECT_EQ(rig.current_a(), 0.0);
    rig.arm();
    rig.run(100);
    EXPECT_EQ(name(rig.controller().state()), "armed");
    EXPECT_EQ(name(rig.snapshot().latch), "none");
  }
}

}  // namespace
}  // namespace hedgehog::safety

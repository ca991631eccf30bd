// SPDX-License-Identifier: MIT
// Contradictions between energy balance, V/I and thermistors that trip by themselves.
#include <gtest/gtest.h>

#include <utility>

#include "tests/control/followed.h"

namespace hedgehog::control {
namespace {

TEST(EstimateCheck, AnEstimateAtSeventyForFiftyMilliseconds) {
  Followed ball(69.6);
  Reason found = Reason::kNone;
  const int ticks = ticks_until_found([&] { return ball.tick(0.0, 69.6); }, found);
  EXPECT_EQ(name(found), "overheated") << "it is likely to be at 70: 69.6 and its deviation";
  EXPECT_GE(ticks, 49);
  EXPECT_LT(ticks, 200);
  Followed cooler(67.0);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(name(cooler.tick(0.0, 67.0)), "none");
}

TEST(EstimateCheck, AResistanceThatFallsWhileTheWindingIsHeatedNamesBoth) {
  Followed ball(30.0);
  for (int i = 0; i < 3000; ++i) ASSERT_EQ(name(ball.tick(10.0, ball.winding_c())), "none");
  const double warm_c = ball.winding_c();
  Reason found = Reason::kNone;
  const int ticks = ticks_until_found([&] { return ball.tick(10.0, warm_c - 25.0); }, found);
  EXPECT_EQ(name(found), "measurements_disagree");
  EXPECT_EQ(ball.disagreement().coil(), kDriven);
  EXPECT_TRUE(ball.disagreement().has(Quantity::kResistance));
  EXPECT_LT(ticks, 1000);
}

TEST(EstimateCheck, AFallBesideAThermistorWithAnOffsetNamesTheThermistorToo) {
  for (const auto& [offset_k, named] :
       {std::pair{0.0, false}, {0.8, false}, {1.5, true}, {3.0, true}}) {
    Followed ball(30.0);
    for (int i = 0; i < 8000; ++i) {
      ball.show(kDriven, ball.winding_c() + offset_k);
      ASSERT_EQ(name(ball.tick(6.0, ball.winding_c())), "none") << offset_k << " K, " << i;
    }
    const double warm_c = ball.winding_c();
    Reason found = Reason::kNone;
    ticks_until_found([&] { return ball.tick(6.0, warm_c - 25.0); }, found);
    EXPECT_EQ(name(found), "measurements_disagree");
    EXPECT_TRUE(ball.disagreement().has(Quantity::kResistance));
    EXPECT_EQ(ball.disagreement().has(Quantity::kThermistor), named) << offset_k << " K";
  }
}

/// Ticks until a fall of V/I by `fall_k` at `current_a` is reported, `settled` ticks after the
/// current was `before_a`.
int ticks_until_fall_found(double before_a, double current_a, int settled, double fall_k) {
  Followed ball(30.0);
  const auto play = [&](double ampere, int ticks) {
    for (int i = 0; i < ticks; ++i) ASSERT_EQ(name(ball.tick(ampere, ball.winding_c())), "none");
  };
  play(before_a, 6000);
  play(current_a, settled);
  const double fallen_c = ball.winding_c() - fall_k;
  Reason found = Reason::kNone;
  const int ticks = ticks_until_found([&] { return ball.tick(current_a, fallen_c); }, found);
  EXPECT_EQ(name(found), "measurements_disagree");
  return ticks;
}

// The filter rejects V/I for 0.3 s before that is reported.
TEST(EstimateCheck, AFallBeyondItsThresholdIsFoundBeforeTheFilterRejectsVI) {
  struct Case {
    double current_a, fall_k;
    int min_ticks, max_ticks;
  };
  for (const auto& [current_a, fall_k, min_ticks, max_ticks] : {Case{5.0, 7.5, 299, 299},
                                                                {5.0, 9.5, 245, 253},
                                                                {8.0, 7.0, 299, 299},
                                                                {8.0, 8.0, 258, 266},
                                                                {12.0, 7.0, 299, 299},
                                                                {12.0, 13.0, 194, 200}}) {
    const int ticks = ticks_until_fall_found(current_a, current_a, 0, fall_k);
    EXPECT_GE(ticks, min_ticks) << current_a << " A, " << fall_k << " K";
    EXPECT_LE(ticks, max_ticks) << current_a << " A, " << fall_k << " K";
  }
}

TEST(EstimateCheck, AFallIsComparedAtTheSameCurrentOfHalfASecond) {
  EXPECT_LT(ticks_until_fall_found(12.0 / 1.08, 12.0, 100, 9.0), 240) << "8 % are the same current";
  const double other_a = 12.0 / 1.15;
  EXPECT_EQ(ticks_until_fall_found(other_a, 12.0, 300, 9.0), 299) << "found by the filter";
  EXPECT_NEAR(ticks_until_fall_found(other_a, 12.0, 400, 9.0), 250, 4);
  EXPECT_LT(ticks_until_fall_found(other_a, 12.0, 550, 9.0), 220);
}

TEST(EstimateCheck, AWindingThatCooledWhileTheBridgesSleptHasNotFallen) {
  Followed ball(30.0);
  for (int i = 0; i < 12'000; ++i) {
    ball.show(kDriven, 30.0 + 0.001 * i);
    ASSERT_EQ(name(ball.tick(12.0, ball.winding_c())), "none") << i;
  }
  const double warm_c = ball.winding_c();
  for (int i = 0; i < 200'000; ++i) {
    ball.show(kDriven, ball.winding_c());
    ASSERT_EQ(name(ball.sleep()), "none") << i;
  }
  ASSERT_LT(ball.winding_c(), warm_c - 6.0);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(name(ball.tick(12.0, ball.winding_c())), "none") << i;
}

TEST(EstimateCheck, VIThatIsRejectedBetweenPausesOnlyDoesNotAddUp) {
  Followed ball(30.0);
  for (int i = 0; i < 3000; ++i) ASSERT_EQ(name(ball.tick(8.0, ball.winding_c())), "none");
  for (int pulse = 0; pulse < 8; ++pulse) {
    for (int i = 0; i < 100; ++i) ASSERT_EQ(name(ball.tick(8.0, ball.winding_c() + 20.0)), "none");
    for (int i = 0; i < 1100; ++i) ASSERT_EQ(name(ball.tick(0.0, 30.0)), "none") << pulse;
  }
}

TEST(EstimateCheck, ADeviatingThermistorIsNamed) {
  Followed ball(30.0);
  for (int i = 0; i < 3000; ++i) ASSERT_EQ(name(ball.tick(0.0, 30.0)), "none");
  ball.show(2, 50.0);
  Reason found = Reason::kNone;
  const int ticks = ticks_until_found([&] { return ball.tick(0.0, 30.0); }, found);
  EXPECT_EQ(name(found), "measurements_disagree");
  EXPECT_EQ(ball.disagreement().coil(), 2);
  EXPECT_TRUE(ball.disagreement().has(Quantity::kThermistor));
  EXPECT_GE(ticks, 900) << "it must stay so for a second";
  EXPECT_LT(ticks, 2000);
}

TEST(EstimateCheck, ADeviatingThermistorThatIsLostDoesNotAddUp) {
  Followed ball(30.0);
  for (int i = 0; i < 3000; ++i) ASSERT_EQ(name(ball.tick(0.0, 30.0)), "none");
  ball.show(2, 50.0);
  for (int times = 0; times < 4; ++times) {
    ball.set_thermistor(2, true);
    for (int i = 0; i < 800; ++i) ASSERT_EQ(name(ball.tick(0.0, 30.0)), "none") << times;
    ball.set_thermistor(2, false);
    for (int i = 0; i < 2000; ++i) ASSERT_EQ(name(ball.tick(0.0, 30.0)), "none") << times;
  }
}

TEST(EstimateCheck, AFallOfVIThatTheSupplysReadingExplainsNamesThat) {
  Followed ball(30.0);
  ball.supply_known = true;
  const auto read = [&](double gain) {
    ball.r25_gain = gain;
    ball.supply_v = 12.0 * gain;
    ball.show(kDriven, ball.winding_c());
    return ball.tick(6.0, ball.winding_c());
  };
  for (int i = 0; i < 8000; ++i) ASSERT_EQ(name(read(1.0)), "none");
  int i = 0;
  Reason found = Reason::kNone;
  ticks_until_found([&] { return read(1.0 - 0.03 * ++i / 19'000); }, found);
  EXPECT_EQ(name(found), "measurements_disagree");
  EXPECT_EQ(ball.disagreement(),
            (Disagreement{kDriven, Quantity::kSupplyVoltage, Quantity::kHeatBalance}));
}

}  // namespace
}  // namespace hedgehog::control

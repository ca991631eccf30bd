// SPDX-License-Identifier: MIT
// What contradicts a reading at the trip temperature.
#include <gtest/gtest.h>

#include "tests/control/followed.h"

namespace hedgehog::control {
namespace {

const Disagreement kResistance{kDriven, Quantity::kResistance, Quantity::kHeatBalance};

/// A winding at `celsius` whose V/I then shows `shown_c` for 250 ms.
Followed shown(double celsius, double shown_c) {
  Followed ball(celsius);
  ball.supply_known = true;
  for (int i = 0; i < 5000; ++i) ball.tick(8.0, ball.winding_c());
  for (int i = 0; i < 250; ++i) ball.tick(8.0, shown_c);
  return ball;
}

TEST(ContradictingHeat, AVIAtTheTripThatNoHeatExplains) {
  EXPECT_EQ(shown(55.0, 80.0).contradicting_heat(), kResistance);
  EXPECT_FALSE(shown(55.0, 69.0).contradicting_heat().any()) << "is not at the trip";
}

TEST(ContradictingHeat, AVIWithinAPercentOfTheEstimateIsHeat) {
  EXPECT_FALSE(shown(65.5, 70.6).contradicting_heat().any());
  EXPECT_TRUE(shown(64.0, 71.0).contradicting_heat().any());
}

TEST(ContradictingHeat, AVIWithinItsOwnErrorIsHeat) {
  const auto found = [](const model::CurrentAccuracy& accuracy) {
    Followed ball(58.0);
    ball.set_accuracy(accuracy);
    for (int i = 0; i < 5000; ++i) ball.tick(8.0, ball.winding_c());
    for (int i = 0; i < 500; ++i) ball.tick(2.0, 60.0);
    for (int i = 0; i < 250; ++i) ball.tick(2.0, 71.0);
    return ball.contradicting_heat();
  };
  EXPECT_TRUE(found({}).any());
  EXPECT_FALSE(found(model::kDriverCsAccuracy).any()) << "0.12 A of 2 A";
}

TEST(ContradictingHeat, AWindingThatIsExpectedAtTheTripIsHot) {
  Followed ball(69.5);
  ball.tick(0.0, 69.5);
  ball.show(2, 75.0);
  ball.tick(0.0, 69.5);
  EXPECT_FALSE(ball.contradicting_heat().any());
}

TEST(ContradictingHeat, OfAColderWindingThanExpectedThereIsNone) {
  EXPECT_FALSE(shown(90.0, 72.0).contradicting_heat().any());
}

TEST(ContradictingHeat, WithoutTheSupplysCurrentItNamesTheCurrentToo) {
  Followed ball(55.0);
  for (int i = 0; i < 5000; ++i) ball.tick(8.0, ball.winding_c());
  for (int i = 0; i < 60; ++i) ball.tick(8.0, 80.0);
  EXPECT_EQ(ball.contradicting_heat(), kResistance.with(Quantity::kCurrent));
}

TEST(ContradictingHeat, AHigherResistanceOfTheColdStartIsNoHeat) {
  Followed ball(70.0);
  ball.r25_gain = 1.03;
  for (int i = 0; i < 3000; ++i) ball.tick(8.0, ball.winding_c());
  EXPECT_FALSE(ball.contradicting_heat().any());
}

TEST(ContradictingHeat, AChangeIsRelativeToTheSupplyAtTheStart) {
  const auto found = [](int ticks, double shown_c) {
    Followed ball(60.0);
    ball.supply_known = true;
    ball.supply_v = 12.5;
    for (int i = 0; i < ticks; ++i) ball.tick(8.0, 60.0);
    for (int i = 0; i < 60; ++i) ball.tick(8.0, shown_c);
    return ball.contradicting_heat();
  };
  EXPECT_EQ(found(6000, 78.0), kResistance);
  EXPECT_FALSE(found(60, 78.0).any())
      << "within 8 % of the device file, which is all that is known";
  EXPECT_EQ(found(60, 105.0), kResistance.with(Quantity::kSupplyVoltage));
}

TEST(ContradictingHeat, AThermistorAtTheTripThatNoHeatExplains) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto found = [&](double celsius, double other_c) {
      Followed ball(celsius);
      ball.tick(0.0, celsius);
      ball.show(coil, other_c);
      ball.tick(0.0, celsius);
      return ball.contradicting_heat();
    };
    const Disagreement thermistor{coil, Quantity::kThermistor, Quantity::kHeatBalance};
    EXPECT_FALSE(found(66.0, 69.9).any());
    EXPECT_EQ(found(66.0, 70.0), thermistor);
    EXPECT_FALSE(found(67.6, 70.2).any()) << "2.6 K are within its tolerance and the estimate's";
    EXPECT_EQ(found(66.6, 70.2), thermistor);
  }
}

TEST(ContradictingHeat, AGuessedTemperatureContradictsNothing) {
  Followed ball(25.0, false);
  for (int i = 0; i < 60; ++i) ball.tick(5.0, 150.0);
  EXPECT_FALSE(ball.contradicting_heat().any());
}

}  // namespace
}  // namespace hedgehog::control

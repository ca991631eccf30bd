// SPDX-License-Identifier: MIT
#include "daemon/control/checks/estimate_check.h"

#include <gtest/gtest.h>

#include <utility>

#include "model/coils.h"

namespace hedgehog::control {
namespace {

constexpr int kDriven = 1;

/// An observer with simulated inputs: a ball at rest, of which one winding carries 10 A.
class Followed {
 public:
  explicit Followed(double celsius, bool known = true) {
    model::ThermalStart start;
    start.nodes = {{celsius, celsius, celsius}, celsius};
    start.known = known;
    observer_ = model::ThermalObserver({}, {}, start);
    measurement_.electrical_valid = true;
    measurement_.supply_v = 12.0;
    measurement_.thermistors.celsius.fill(celsius);
    measurement_.thermistors.valid.fill(true);
  }

  /// A tick in which V/I gives the resistance at `shown_c`.
  Reason tick(double current_a, double shown_c) {
    measurement_.current_before_a[kDriven] = measurement_.current_a[kDriven] = current_a;
    measurement_.voltage_v[kDriven] =
        current_a * model::resistance_at(model::Ohms(0.45), model::Celsius(shown_c)).value;
    observer_.step(measurement_);
    return check_.step(observer_, supply_, 70.0, model::kTickSeconds);
  }
  void show(int coil, double celsius) {
    measurement_.thermistors.celsius[static_cast<std::size_t>(coil)] = celsius;
  }
  double winding_c() const { return observer_.filter().winding_c(kDriven); }
  const Disagreement& disagreement() const { return check_.disagreement(); }
  Disagreement contradicting_heat() const {
    return check_.contradicting_heat(observer_, supply_, 70.0);
  }

 private:
  model::ThermalMeasurement measurement_;
  model::ThermalObserver observer_;
  SupplyBalance supply_;
  EstimateCheck check_;
};

/// Ticks until the check reports a fault, at most 20 s.
template <class Tick>
int ticks_until_found(const Tick& tick, Reason& found) {
  int ticks = 0;
  while ((found = tick()) == Reason::kNone && ticks < 20'000) ++ticks;
  return ticks;
}

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

const Disagreement kVoltageOverCurrent =
    Disagreement{kDriven, Quantity::kResistance, Quantity::kHeatBalance}.with(Quantity::kCurrent);

TEST(EstimateCheck, AVIOfHeatThatNoHeatExplainsIsContradicted) {
  for (const auto& [shown_c, contradicted] : {std::pair{80.0, true}, {69.0, false}}) {
    Followed ball(55.0);
    for (int i = 0; i < 5000; ++i) ASSERT_EQ(name(ball.tick(8.0, ball.winding_c())), "none");
    EXPECT_FALSE(ball.contradicting_heat().any());
    for (int i = 0; i < 60; ++i) ball.tick(8.0, shown_c);
    EXPECT_EQ(ball.contradicting_heat(), contradicted ? kVoltageOverCurrent : Disagreement{})
        << shown_c;
  }
}

TEST(EstimateCheck, AVIThatAgreesWithTheEstimateIsNotContradicted) {
  Followed ball(70.0);
  for (int i = 0; i < 100; ++i) ball.tick(8.0, ball.winding_c() + 2.0);
  EXPECT_FALSE(ball.contradicting_heat().any());
}

TEST(EstimateCheck, AThermistorOfHeatIsContradictedByTheHeatBalance) {
  for (const double other_c : {69.0, 71.0}) {
    Followed ball(66.0);
    ball.tick(0.0, 66.0);
    ball.show(2, other_c);
    ball.tick(0.0, 66.0);
    EXPECT_EQ(ball.contradicting_heat(),
              other_c < 70.0 ? Disagreement{}
                             : (Disagreement{2, Quantity::kThermistor, Quantity::kHeatBalance}));
  }
  Followed warm(69.5);
  warm.tick(0.0, 69.5);
  warm.show(2, 71.0);
  warm.tick(0.0, 69.5);
  EXPECT_FALSE(warm.contradicting_heat().any()) << "1.5 K are within its tolerance";
}

TEST(EstimateCheck, AGuessedTemperatureContradictsNothing) {
  Followed ball(25.0, false);
  for (int i = 0; i < 60; ++i) ball.tick(5.0, 72.0);
  EXPECT_FALSE(ball.contradicting_heat().any());
}

}  // namespace
}  // namespace hedgehog::control

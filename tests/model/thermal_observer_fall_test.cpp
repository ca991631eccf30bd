// SPDX-License-Identifier: MIT
// A resistance that the observer has found to fall, after a rest.
#include <gtest/gtest.h>

#include "tests/model/thermal_measurements.h"

namespace hedgehog::model {
namespace {

/// A ball whose winding 1 has been found to have a fallen resistance, and that has rested since.
class FallenAndRested {
 public:
  /// Without `referenced` it has been compared with the device file only.
  explicit FallenAndRested(bool referenced = true) {
    if (!referenced) {
      ThermalStart start = known(25.0);
      start.nodes.winding_c[2] = 35.0;  // not at rest
      observer = ThermalObserver(CoilModel{}, ThermalModel{}, start);
    }
    for (int step = 0; step < 500; ++step) show(0.0);
    for (int step = 0; step < 3000 && !fall().certain(); ++step) show(2.5);
    was_certain = fall().certain();
    for (int step = 0; step < 36'000; ++step) observer.step(quiet(25.0), kStepOfRestS);
  }
  /// 10 A, with a V/I that gives a winding temperature below the estimate.
  void show(double below_k) {
    observer.step(measurement(1, 10.0, observer.filter().winding_c(1) - below_k, 25.0),
                  kStepOfRestS);
  }
  const ResistanceFall& fall() const { return observer.fall(1); }

  static constexpr double kStepOfRestS = 0.02;
  ThermalObserver observer{CoilModel{}, ThermalModel{}, known(25.0)};
  bool was_certain = false;
};

TEST(ThermalObserver, AFallIsClearedAfterARestByTheEarlierResistance) {
  FallenAndRested ball;
  ASSERT_TRUE(ball.was_certain);
  for (int step = 0; step < 500; ++step) {
    ball.show(0.0);
    ASSERT_FALSE(ball.fall().certain()) << step;
  }
}

TEST(ThermalObserver, AFallCountsAgainOnceTheResistanceAfterARestIsLower) {
  FallenAndRested ball;
  ASSERT_TRUE(ball.was_certain);
  for (int step = 0; step < 30; ++step) ball.show(5.0);
  EXPECT_TRUE(ball.fall().certain()) << "36 A^2s are enough";
}

TEST(ThermalObserver, AFallThatIsNotComparedAfterARestCountsAgain) {
  FallenAndRested ball;
  ASSERT_TRUE(ball.was_certain);
  ASSERT_TRUE(ball.observer.winding(1).rested());
  EXPECT_FALSE(ball.fall().certain());
  ThermalMeasurement unmeasured = measurement(1, 15.0, 25.0, 25.0);
  unmeasured.current_measured[1] = false;
  for (int step = 0; step < 100; ++step)
    ball.observer.step(unmeasured, FallenAndRested::kStepOfRestS);
  EXPECT_TRUE(ball.fall().certain()) << "warmed by more than what it may be compared after";
}

/// Whether it is certain when it has taken its reference, at a V/I that is `below_k` too cool.
bool certain_when_referenced(FallenAndRested& ball, double below_k) {
  for (int step = 0; step < 100 && !ball.observer.winding(1).referenced(); ++step)
    ball.show(below_k);
  EXPECT_TRUE(ball.observer.winding(1).referenced());
  return ball.fall().certain();
}

TEST(ThermalObserver, BeforeItsFirstReferenceAFallIsComparedWithTheDeviceFile) {
  FallenAndRested same(false);
  ASSERT_TRUE(same.was_certain);
  EXPECT_FALSE(certain_when_referenced(same, 0.0));
  FallenAndRested lower(false);
  EXPECT_TRUE(certain_when_referenced(lower, 11.5));
  FallenAndRested sound(false);
  sound.observer = ThermalObserver(CoilModel{}, ThermalModel{}, known(25.0));
  EXPECT_FALSE(certain_when_referenced(sound, 11.5)) << "not by these measurements alone";
}

}  // namespace
}  // namespace hedgehog::model

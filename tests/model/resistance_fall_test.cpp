// SPDX-License-Identifier: MIT
#include "model/estimate/resistance_fall.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <utility>
#include <vector>

#include "model/random_stream.h"

namespace hedgehog::model {
namespace {

constexpr double kFallWindowS = 0.1;

TEST(ResistanceFall, IsCertainAfterManySmallDeviationsDownwards) {
  ResistanceFall fall;
  int windows = 0;
  for (; !fall.certain() && windows < 1000; ++windows) fall.add(-1.0, false);
  EXPECT_NEAR(windows, 101, 1) << "each counts for what is beyond 0.4";
  ResistanceFall beside;
  for (int i = 0; i < 150; ++i) beside.add(-1.0, true);
  EXPECT_FALSE(beside.certain()) << "where each winding has a thermistor only what is beyond 0.7";
}

TEST(ResistanceFall, NoiseIsNoFall) {
  ResistanceFall fall;
  RandomStream random(7);
  for (int i = 0; i < 36'000; ++i) {
    fall.add(random.gaussian(), false);
    ASSERT_FALSE(fall.certain());
  }
}

TEST(ResistanceFall, RaisesTheBoundLongBeforeItIsCertainAndGivesItBackInMinutes) {
  ResistanceFall fall;
  for (int i = 0; i < 50; ++i) fall.add(-1.0, false);
  EXPECT_FALSE(fall.certain());
  EXPECT_NEAR(fall.margin_k(), 2.5, 0.01);
  for (int i = 0; i < 50; ++i) fall.add(1.0, false);
  EXPECT_NEAR(fall.margin_k(), 2.5, 0.01) << "not at once: R25 may stay changed";
  for (int i = 0; i < 3000; ++i) fall.age(kFallWindowS);
  EXPECT_NEAR(fall.margin_k(), 2.5 / 2.718, 0.02);
}

constexpr double kFileOhm = 0.45;
constexpr double kFileDeviation = 0.03;
constexpr double kOffsetA = 0.1;
constexpr RestResistance kFirst{0.44, 0.1};

/// A winding whose first reference is `kFirst`, and whose resistance has fallen since then.
ResistanceFall fallen(double deviations = -2.0) {
  ResistanceFall fall(kFileOhm, kFileDeviation);
  fall.rest();
  fall.compare(kFirst, kOffsetA);
  for (int i = 0; i < 60; ++i) fall.add(deviations, false);
  return fall;
}

RestResistance shares_of_the_first(double share) { return {share * kFirst.ohm, kFirst.per_ampere}; }

TEST(ResistanceFall, StaysCertainHoweverLongNothingIsMeasured) {
  ResistanceFall fall = fallen();
  for (int i = 0; i < 36'000; ++i) fall.age(kFallWindowS);
  EXPECT_TRUE(fall.certain());
}

TEST(ResistanceFall, IsSuspendedAtARestAndClearedByTheEarlierResistance) {
  ResistanceFall fall = fallen();
  fall.rest();
  EXPECT_FALSE(fall.certain()) << "the next current shows its resistance at a known temperature";
  fall.compare(shares_of_the_first(0.991), kOffsetA);
  EXPECT_FALSE(fall.certain());
  fall.resume();
  EXPECT_FALSE(fall.certain());
}

TEST(ResistanceFall, CountsAgainWhenTheResistanceIsLowerThanBefore) {
  ResistanceFall fall = fallen();
  fall.rest();
  fall.compare(shares_of_the_first(0.989), kOffsetA);
  EXPECT_TRUE(fall.certain());
}

TEST(ResistanceFall, CountsAgainWhenNoReferenceIsTaken) {
  ResistanceFall fall = fallen();
  fall.rest();
  fall.resume();
  EXPECT_TRUE(fall.certain());
}

TEST(ResistanceFall, OneThatEndedByItselfDoesNotKeepTheFirstReferenceFromBeingTaken) {
  ResistanceFall fall(kFileOhm, kFileDeviation);
  fall.add(-3.0, false);
  fall.rest();
  fall.resume();
  for (int i = 0; i < 10; ++i) fall.add(3.0, false);
  fall.rest();
  fall.compare({0.9 * kFileOhm, 0.1}, kOffsetA);
  for (int i = 0; i < 60; ++i) fall.add(-2.0, false);
  ASSERT_TRUE(fall.certain());
  fall.rest();
  fall.compare({0.9 * kFileOhm, 0.1}, kOffsetA);
  EXPECT_FALSE(fall.certain()) << "as at its first reference";
}

TEST(ResistanceFall, IsComparedWithTheResistanceBeforeItHoweverOftenTheWindingRests) {
  ResistanceFall fall = fallen();
  for (int rests = 0; rests < 3; ++rests) {
    fall.rest();
    fall.compare(shares_of_the_first(0.95), kOffsetA);
    ASSERT_TRUE(fall.certain()) << rests;
  }
  fall.rest();
  fall.compare(shares_of_the_first(1.0), kOffsetA);
  EXPECT_FALSE(fall.certain());
}

TEST(ResistanceFall, AnUncertainOneIsNotClearedByARestEither) {
  ResistanceFall fall = fallen(-1.0);
  ASSERT_FALSE(fall.certain());
  fall.rest();
  fall.compare(shares_of_the_first(0.98), kOffsetA);
  int windows = 0;
  for (; !fall.certain() && windows < 1000; ++windows) fall.add(-1.0, false);
  EXPECT_NEAR(windows, 41, 1) << "60 windows came before the rest";
}

TEST(ResistanceFall, ANewOneIsFoundWhileTheWindingIsCompared) {
  ResistanceFall fall = fallen();
  fall.rest();
  int windows = 0;
  for (; !fall.certain() && windows < 1000; ++windows) fall.add(-1.0, false);
  EXPECT_NEAR(windows, 101, 1);
  fall.rest();
  fall.compare(shares_of_the_first(1.0), kOffsetA);
  EXPECT_FALSE(fall.certain());
}

TEST(ResistanceFall, IsNotClearedByACurrentWhoseOffsetCouldHideIt) {
  for (const double per_ampere : {0.21, -0.01}) {
    ResistanceFall fall = fallen();
    fall.rest();
    fall.compare({kFirst.ohm, per_ampere}, kOffsetA);
    EXPECT_TRUE(fall.certain()) << "0.1 A make 1.1 %";
  }
  ResistanceFall fall = fallen();
  fall.rest();
  fall.compare({kFirst.ohm, 0.19}, kOffsetA);
  EXPECT_FALSE(fall.certain());
}

TEST(ResistanceFall, ADecayedOneIsNotSuspendedAgain) {
  ResistanceFall fall = fallen();
  fall.rest();
  fall.resume();
  for (int i = 0; i < 60; ++i) fall.add(2.0, false);
  ASSERT_FALSE(fall.certain());
  fall.rest();
  fall.resume();
  EXPECT_FALSE(fall.certain());
}

TEST(ResistanceFall, WithoutAReferenceBeforeItIsComparedWithTheFile) {
  for (const auto& [share, certain] : {std::pair{0.961, false}, {0.959, true}}) {
    ResistanceFall fall(kFileOhm, kFileDeviation);
    for (int i = 0; i < 60; ++i) fall.add(-2.0, false);
    fall.rest();
    fall.compare({share * kFileOhm, 0.05}, kOffsetA);
    EXPECT_EQ(fall.certain(), certain) << share;
  }
}

TEST(ResistanceFall, IsNotClearedByTheFileWhenAnOffsetCouldHideIt) {
  ResistanceFall fall(kFileOhm, kFileDeviation);
  for (int i = 0; i < 60; ++i) fall.add(-2.0, false);
  fall.rest();
  fall.compare({kFileOhm, -0.5}, kOffsetA);
  EXPECT_TRUE(fall.certain()) << "0.1 A make 5 %";
}

TEST(ResistanceFall, OneThatBeganAtARestIsNotItsOwnReference) {
  ResistanceFall fall(kFileOhm, kFileDeviation);
  fall.rest();
  fall.compare(shares_of_the_first(1.0), kOffsetA);
  fall.rest();
  fall.compare(shares_of_the_first(0.9), kOffsetA);
  for (int i = 0; i < 60; ++i) fall.add(-2.0, false);
  ASSERT_TRUE(fall.certain());
  for (int rests = 0; rests < 3; ++rests) {
    fall.rest();
    fall.compare(shares_of_the_first(0.9), kOffsetA);
    EXPECT_TRUE(fall.certain()) << rests;
  }
}

TEST(ResistanceFall, ManySmallOnesAreClearedOnlyUpToTheToleranceOfOne) {
  ResistanceFall fall = fallen();
  double share = 1.0;
  for (int rests = 0; rests < 12; ++rests) {
    share *= 0.991;
    fall.rest();
    fall.compare(shares_of_the_first(share), kOffsetA);
    EXPECT_EQ(fall.certain(), share < 0.99) << share;
    for (int i = 0; i < 60; ++i) fall.add(-2.0, false);
  }
}

TEST(ResistanceFall, BurstsBetweenRestsAddUp) {
  ResistanceFall fall = fallen(0.0);
  for (int bursts = 0; bursts < 2; ++bursts) {
    fall.rest();
    for (int i = 0; i < 35; ++i) fall.add(-1.5, false);
    EXPECT_FALSE(fall.certain());
    fall.compare(shares_of_the_first(0.95), kOffsetA);
  }
  EXPECT_TRUE(fall.certain()) << "38 and 38";
}

RC_GTEST_PROP(ResistanceFall, ItsMarginIsWithinBounds, (const std::vector<std::int8_t>& tenths)) {
  ResistanceFall fall;
  for (const std::int8_t tenth : tenths) {
    fall.add(tenth, tenth % 2 == 0);
    RC_ASSERT(fall.margin_k() >= 0.0);
    RC_ASSERT(fall.margin_k() <= ResistanceFall::kMaxMarginK);
    RC_ASSERT(!fall.certain() || fall.margin_k() == ResistanceFall::kMaxMarginK);
  }
}

}  // namespace
}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
#include "model/estimate/resistance_fall.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "model/random_stream.h"

namespace hedgehog::model {
namespace {

constexpr double kWindow = 0.1;

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
  for (int i = 0; i < 3000; ++i) fall.age(kWindow);
  EXPECT_NEAR(fall.margin_k(), 2.5 / 2.718, 0.02);
}

RC_GTEST_PROP(ResistanceFall, ItsDoubtIsWithinBounds, (const std::vector<std::int8_t>& tenths)) {
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

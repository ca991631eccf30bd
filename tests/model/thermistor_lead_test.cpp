// SPDX-License-Identifier: MIT
// The lead of a thermistor: two smoothing filters, and what it shows without readings.
#include "model/estimate/thermistor_lead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/tick.h"

namespace hedgehog::model {
namespace {

void show(ThermistorLead& lead, double celsius, int steps) {
  for (int step = 0; step < steps; ++step) lead.step(true, celsius, kTickSeconds);
}
void stay_silent(ThermistorLead& lead, int steps) {
  for (int step = 0; step < steps; ++step)
    lead.step(false, std::numeric_limits<double>::quiet_NaN(), kTickSeconds);
}

TEST(ThermistorLead, IsItsStartUntilTheFirstReadingAndThenThat) {
  ThermistorLead lead(60.0);
  EXPECT_EQ(lead.celsius(), 60.0);
  EXPECT_EQ(lead.smooth_c(), 60.0);
  show(lead, 40.0, 1);
  EXPECT_EQ(lead.celsius(), 40.0);
  EXPECT_EQ(lead.smooth_c(), 40.0);
}

TEST(ThermistorLead, SmoothsOverAQuarterOfASecond) {
  ThermistorLead lead;
  show(lead, 20.0, 100);
  show(lead, 30.0, 250);
  EXPECT_NEAR(lead.smooth_c(), 30.0 - 10.0 * std::exp(-1.0), 0.01);
  // The second filter, a second, follows the first.
  const double slow_c = 30.0 - 10.0 * (std::exp(-0.25) - 0.25 * std::exp(-1.0)) / 0.75;
  EXPECT_NEAR(lead.celsius(), lead.smooth_c() + 2.25 * (lead.smooth_c() - slow_c), 0.02);
}

TEST(ThermistorLead, IsTwoSecondsAheadOfASteadyChange) {
  for (const double rate_k_s : {-0.5, 1.5}) {
    ThermistorLead lead;
    double shown_c = 30.0;
    for (int step = 0; step < 10'000; ++step)
      lead.step(true, shown_c += rate_k_s * kTickSeconds, kTickSeconds);
    EXPECT_NEAR(lead.celsius(), shown_c + 2.0 * rate_k_s, 1e-2);
    EXPECT_NEAR(lead.smooth_c(), shown_c - 0.25 * rate_k_s, 1e-2);
  }
}

TEST(ThermistorLead, HoldsItsValueForATenthOfASecondAndIsLostThen) {
  ThermistorLead lead;
  show(lead, 40.0, 100);
  stay_silent(lead, 99);
  EXPECT_EQ(lead.celsius(), 40.0);
  EXPECT_FALSE(lead.lost());
  stay_silent(lead, 2);
  EXPECT_TRUE(lead.lost());
  EXPECT_EQ(lead.celsius(), 40.0);
}

TEST(ThermistorLead, SmoothsOverAShortSilenceAndBeginsAnewAfterALongOne) {
  ThermistorLead brief;
  show(brief, 40.0, 100);
  stay_silent(brief, 90);
  show(brief, 50.0, 1);
  EXPECT_LT(brief.smooth_c(), 40.1);
  stay_silent(brief, 90);
  EXPECT_FALSE(brief.lost()) << "a reading ends the silence";
  stay_silent(brief, 20);
  ASSERT_TRUE(brief.lost());
  show(brief, 50.0, 1);
  EXPECT_EQ(brief.celsius(), 50.0);
  EXPECT_FALSE(brief.lost());
}

}  // namespace
}  // namespace hedgehog::model

// SPDX-License-Identifier: MIT
// Simulated people against the reference figures of the method (study-rules.md, section 6).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "clients/study/experiment_file.h"
#include "clients/study/rules/analysis.h"
#include "clients/study/rules/distinguishable_levels.h"
#include "clients/study/rules/simulation.h"
#include "clients/study/rules/statistics.h"
#include "tests/study/answered.h"

namespace hedgehog::study {
namespace {

struct Reference {
  const char* experiment;
  double estimate, error_sd, trials;
  /// Quantiles of the error, and the standard deviation of each between samples of 2 000.
  double error_5, spread_5, error_95, spread_95;
};
constexpr int kPeople = 2000;

class TwoThousandPeople : public testing::TestWithParam<Reference> {};

TEST_P(TwoThousandPeople, AreWithinThreeStandardErrorsOfTheReference) {
  const Reference& reference = GetParam();
  const Experiment e = find_experiment(reference.experiment).value();
  const auto runs = simulate(e, thesis_population(e.quantity), {kPeople, 2026, 2, false});
  const SimulationSummary s = summarise(e, runs);
  EXPECT_EQ(s.finished, kPeople);
  // The difference of two samples of 2 000 has sqrt(2) times the standard error of one.
  const double root = std::sqrt(2.0 / kPeople);
  EXPECT_NEAR(s.estimate_mean, reference.estimate, 3 * root * s.estimate_sd);
  EXPECT_NEAR(s.trials_mean, reference.trials, 3 * root * s.trials_sd);
  EXPECT_NEAR(s.error_5, reference.error_5, 3 * std::sqrt(2.0) * reference.spread_5);
  EXPECT_NEAR(s.error_95, reference.error_95, 3 * std::sqrt(2.0) * reference.spread_95);
  double fourth = 0.0;
  for (const SimulatedRun& run : runs)
    fourth += std::pow(run.estimate - run.true_point - s.bias, 4) / kPeople;
  const double kurtosis = fourth / std::pow(s.error_sd, 4);
  EXPECT_NEAR(s.error_sd, reference.error_sd,
              3 * root * s.error_sd * std::sqrt((kurtosis - 1) / 4));
}

INSTANTIATE_TEST_SUITE_P(
    Study, TwoThousandPeople,
    testing::Values(Reference{"force-threshold", 2.231, 0.194, 54.1, -0.24, 0.012, 0.38, 0.017},
                    Reference{"force-jnd", 15.44, 5.06, 41.2, -6.0, 0.22, 10.1, 0.33},
                    Reference{"speed-jnd", 54.14, 19.5, 36.1, -36, 1.6, 28, 1.5}),
    [](const auto& reference) {
      std::string name = reference.param.experiment;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST(Convergence, IsAt80Point35PercentForSmallSteps) {
  const StaircaseRule rule = find_experiment("force-jnd").value().rule;
  EXPECT_NEAR(convergence_point(rule), std::sqrt(1.0 / 1.5488), 1e-12);
  const auto two = [&](double step) {
    return long_run_convergence(rule, Task::kTwoIntervals, step, 60'000, 7);
  };
  EXPECT_NEAR(two(0.02), 0.8035, 0.006);
  EXPECT_NEAR(two(0.1), 0.807, 0.006);
  EXPECT_NEAR(two(0.5), 0.824, 0.008);
  EXPECT_NEAR(two(1.0), 0.851, 0.008);
  const auto yes_no = [&](double step) {
    return long_run_convergence(rule, Task::kYesNo, step, 60'000, 7);
  };
  EXPECT_NEAR(yes_no(0.02), 0.808, 0.006);
  EXPECT_NEAR(yes_no(0.3), 0.858, 0.006);
}

TEST(Convergence, FollowsTheStepRatioOfEachRule) {
  // Garcia-Perez 1998: ratios for one to four positives in a row.
  const double points[] = {0.7785, 0.8035, 0.8315, 0.8584};
  const Level ratios[] = {2845, 5488, 7393, 8415};
  for (int n = 1; n <= 4; ++n) {
    StaircaseRule rule;
    rule.stages = {{10000, ratios[n - 1], 1}};
    rule.positives_down = n;
    EXPECT_NEAR(convergence_point(rule), points[n - 1], 1e-3) << n;
  }
}

TEST(Observer, IsPositiveIn80PercentAtTheThresholdAndHasAnInverse) {
  for (const Curve curve : {Curve::kWeibull, Curve::kLogistic}) {
    Observer o{curve, 13.0, 2.0, 0.5, 0.0, 0.6};
    EXPECT_NEAR(o.positive_at(13.0), 0.8, 1e-12);
    EXPECT_NEAR(o.positive_at(o.level_at(0.9)), 0.9, 1e-9);
    EXPECT_EQ(o.positive_at(0.0), 0.5);
    o.lapse = 0.02;
    EXPECT_NEAR(o.positive_at(1e6), 0.98, 1e-12);
  }
}

TEST(Analysis, FindsAPersonsThresholdInThreeWays) {
  const Experiment e = find_experiment("force-jnd").value();
  const Observer o{Curve::kWeibull, 13.0, 2.0, 0.5, 0.02, 0.6};
  int covered = 0;
  std::vector<double> fits;
  for (std::uint64_t person = 0; person < 60; ++person) {
    const RunAnalysis a = analyse(e, answered(e, o, person), {});
    ASSERT_TRUE(a.threshold && a.fit && a.interval);
    EXPECT_NEAR(*a.weber_fraction, *a.threshold / 100.0, 1e-12);
    EXPECT_NEAR(*a.force_n, *a.threshold / 100.0 * 5 * 0.0126, 1e-12);
    fits.push_back(a.fit->threshold);
    const double threshold = o.level_at(0.8035);
    covered += a.interval->contains(threshold) ? 1 : 0;
  }
  EXPECT_NEAR(mean(fits), o.level_at(0.8035), 2.5);
  EXPECT_GE(covered, 52);  // nominally 57 of 60
}

TEST(Analysis, FlagsAThresholdOutsideItsInterval) {
  const Experiment e = find_experiment("speed-jnd").value();
  // An observer with a lapse rate of 30 %, which the fit does not expect.
  const Observer o{Curve::kWeibull, 45.0, 0.6, 0.5, 0.3, 0.6};
  int outside = 0;
  for (std::uint64_t person = 0; person < 60; ++person) {
    const RunAnalysis a = analyse(e, answered(e, o, person), {});
    const bool excluded = !a.interval->contains(*a.threshold);
    EXPECT_EQ(std::count(a.flags.begin(), a.flags.end(), Flag::kDisagreement), excluded ? 1 : 0);
    outside += excluded ? 1 : 0;
  }
  EXPECT_GT(outside, 0);
  EXPECT_LT(outside, 30);
}

TEST(Analysis, FlagsAGuessingObserver) {
  const Experiment e = find_experiment("speed-jnd").value();
  const Observer guessing{Curve::kWeibull, 1e9, 2.0, 0.5, 0.0, 0.6};
  const Observer person{Curve::kWeibull, 45.0, 2.0, 0.5, 0.02, 0.6};
  const auto flagged = [&](const Observer& o) {
    int count = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      const auto flags = analyse(e, answered(e, o, i), {}).flags;
      count += static_cast<int>(std::count(flags.begin(), flags.end(), Flag::kGuessing));
    }
    return count;
  };
  EXPECT_GE(flagged(guessing), 80);
  EXPECT_LE(flagged(person), 5);
}

TEST(Analysis, FlagsFalseAlarmsAndFloors) {
  const Experiment e = find_experiment("force-threshold").value();
  const Observer yes{Curve::kWeibull, 2.1, 3.0, 0.999, 0.0, 0.8};
  EXPECT_THAT(analyse(e, answered(e, yes, 3), {}).flags,
              testing::IsSupersetOf({Flag::kFalseAlarms, Flag::kEarlyFloor, Flag::kZeroLevel}));
  const Observer person{Curve::kWeibull, 2.1, 3.0, 0.02, 0.02, 0.8};
  EXPECT_THAT(analyse(e, answered(e, person, 3), {}).flags, testing::IsEmpty());
}

TEST(Analysis, AnUnfinishedRunHasNoThreshold) {
  const Experiment e = find_experiment("force-jnd").value();
  const RunAnalysis a = analyse(e, RunState(e, {1, 1}, false), {});
  EXPECT_FALSE(a.threshold);
  EXPECT_THAT(a.flags, testing::Contains(Flag::kNotFinished));
}

TEST(DistinguishableLevels, DependOnFormulaAndRange) {
  // The thesis: 2.1 A, 13 %, 49 %, "about 10" levels of force and "about 20" of speed.
  EXPECT_EQ(count_levels(2.1, 15, 0.13, Spacing::kWeber, 5).levels, 17);
  EXPECT_EQ(count_levels(2.1, 5, 0.13, Spacing::kWeber, 5).levels, 8);
  EXPECT_NEAR(count_levels(5, 15, 0.13, Spacing::kWeber, 5).steps + 1, 9.99, 0.01);
  EXPECT_NEAR(count_levels(2.1, 15, 0.13, Spacing::kConstant, 5, 2).steps, 9.9, 0.05);
  EXPECT_NEAR(count_levels(2.1, 15, 0.13, Spacing::kWeberTwoPrime, 5).steps, 9.6, 0.05);
  EXPECT_NEAR(count_levels(2.1, 15, 0.13, Spacing::kConstant, 5).steps, 19.8, 0.05);
  EXPECT_NEAR(count_levels(1, 100, 0.49, Spacing::kConstant, 10).steps, 20.2, 0.05);
  EXPECT_NEAR(count_levels(1, 50, 0.49, Spacing::kWeber, 10).steps, 9.8, 0.05);
  EXPECT_NEAR(count_levels(1, 50, 0.49, Spacing::kConstant, 10).steps, 10.0, 0.05);
  const auto rows = level_formulas(2.1, 0.13, 0.49);
  EXPECT_EQ(rows.front().count.levels, 17);
  EXPECT_EQ(rows[2].remark, "1 + steps = 9.99: the thesis' \"about 10\"");
  EXPECT_EQ(rows[3].remark, "the steps: the thesis' \"about 10\"");
  std::string remarks;
  for (const std::string& remark : level_remarks(2.1, 0.13, 0.49)) {
    EXPECT_LE(remark.size(), 78U);
    remarks += remark + "\n";
  }
  EXPECT_NE(remarks.find("2,909 to 1"), std::string::npos) << remarks;
  EXPECT_NE(remarks.find("98 pins/s"), std::string::npos) << remarks;
  EXPECT_NE(remarks.find("may be swapped"), std::string::npos) << remarks;
  // Invalid ranges have no levels; the maximum is that of an int.
  EXPECT_EQ(count_levels(16, 15, 0.13, Spacing::kWeber, 5).levels, 0);
  EXPECT_EQ(count_levels(5.5, 5, 0.13, Spacing::kConstant, 5).levels, 0);
  EXPECT_EQ(count_levels(0, 15, 0.13, Spacing::kWeber, 5).levels, 0);
  EXPECT_EQ(count_levels(2, 15, 0, Spacing::kConstant, 5).levels, 0);
  EXPECT_GT(count_levels(2.1, 15, 1e-12, Spacing::kWeber, 5).levels, 999'999'999);
  // The remarks depend on the numbers.
  EXPECT_EQ(level_formulas(2.1, 0.3, 0.49)[2].remark, "");
  EXPECT_EQ(level_remarks(2.1, 0.3, 0.49).size(), 2U);
}

TEST(Statistics, AreThoseOfTheTextbook) {
  EXPECT_EQ(mean({1, 2, 6}), 3);
  EXPECT_NEAR(standard_deviation({1, 2, 6}), std::sqrt(7.0), 1e-12);
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({0, 10}, 0.25), 2.5);
  EXPECT_NEAR(coin_tail(9, 10), 11.0 / 1024, 1e-12);
  EXPECT_NEAR(correlation({1, 2, 3}, {2, 4, 6}), 1, 1e-12);
}

}  // namespace
}  // namespace hedgehog::study

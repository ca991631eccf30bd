// SPDX-License-Identifier: MIT
// A run apart from its staircase: practice, catch trials, interval order, void trials.
#include <gtest/gtest.h>

#include <string>

#include "clients/study/experiment_file.h"
#include "clients/study/rules/run.h"
#include "tests/study/preset.h"

namespace hedgehog::study {
namespace {

constexpr RunSeeds kSeeds{11, 22};

Answer right(const Trial& trial) {
  return trial.interval_of_test == 1 ? Answer::kFirst : Answer::kSecond;
}

TEST(Run, AVoidRepeatsTheLevelWithANewOrderAndShiftsNoTrial) {
  const Experiment e = preset("force-jnd");
  RunState reference(e, kSeeds);
  RunState with_voids(e, kSeeds);
  int trials = 0;
  int reordered = 0;
  while (const auto trial = reference.next()) {
    ASSERT_EQ(with_voids.next(), trial);
    RunState voided = with_voids;
    bool turned = false;
    for (int attempt = 2; attempt <= 4; ++attempt) {
      voided.make_void();
      ASSERT_EQ(voided.next()->level, trial->level);
      ASSERT_EQ(voided.next()->number, trial->number);
      ASSERT_EQ(voided.next()->attempt, attempt);
      turned = turned || voided.next()->interval_of_test != trial->interval_of_test;
    }
    ++trials;
    reordered += turned ? 1 : 0;
    const Answer given = reference.judgements().size() % 4 == 3 ? Answer::kFirst : right(*trial);
    reference.answer(given);
    // The same correctness after the void trials, whatever the new interval order.
    const bool was_right = given == right(*trial);
    const Answer same =
        (voided.next()->interval_of_test == 1) == was_right ? Answer::kFirst : Answer::kSecond;
    voided.answer(same);
    with_voids = reference;
    ASSERT_EQ(voided.next(), reference.next());
  }
  // Three random orders for each trial: in 7/8 of the trials at least one differs.
  EXPECT_GT(trials, 20);
  EXPECT_GT(reordered, trials * 2 / 3);
  EXPECT_LT(reordered, trials);
}

TEST(Run, CatchTrialsAreOneInSixNeverTheFirstNeverTwoInARowAndMoveNothing) {
  const Experiment e = preset("force-threshold");
  int catches = 0;
  int all = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RunState run(e, {1, seed}, false);
    bool last_was_catch = true;  // because the first must not be one
    while (const auto trial = run.next()) {
      ++all;
      const bool is_catch = trial->kind == TrialKind::kCatch;
      ASSERT_FALSE(is_catch && last_was_catch);
      last_was_catch = is_catch;
      const StaircaseState before = run.staircase().state();
      run.answer(trial->level > 20000 || seed % 2 == 0 ? Answer::kYes : Answer::kNo);
      if (is_catch) {
        ++catches;
        EXPECT_EQ(trial->level, 0);
        EXPECT_EQ(run.staircase().state(), before);
      }
    }
  }
  EXPECT_NEAR(static_cast<double>(catches) / all, 1.0 / 6.0, 0.01);
}

TEST(Run, TheTestIsInEitherIntervalHalfOfTheTime) {
  int second = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed)
    second += RunState(preset("force-jnd"), {seed, 0}, false).next()->interval_of_test - 1;
  EXPECT_NEAR(second, 1000, 100);
}

TEST(Run, BalancedOrderReversesTheSecondOfEachPair) {
  Experiment e = preset("force-jnd");
  e.order = IntervalOrder::kBalanced;
  RunState run(e, kSeeds, false);
  int first = 0;
  while (const auto trial = run.next()) {
    if (trial->number % 2 == 0) EXPECT_EQ(trial->interval_of_test, 3 - first);
    first = trial->interval_of_test;
    run.answer(trial->number % 3 == 0 ? Answer::kFirst : right(*trial));
  }
}

TEST(Run, PracticeIsNeverScored) {
  RunState run(preset("speed-jnd"), kSeeds);
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(run.next()->kind, TrialKind::kPractice);
    EXPECT_EQ(run.next()->number, i);
    run.answer(Answer::kFirst);
  }
  EXPECT_EQ(run.next()->kind, TrialKind::kScored);
  EXPECT_EQ(run.staircase().state(), Staircase(preset("speed-jnd").rule).state());
}

}  // namespace
}  // namespace hedgehog::study

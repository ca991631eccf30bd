// SPDX-License-Identifier: MIT
#include "clients/study/rules/run.h"

#include <cassert>

namespace hedgehog::study {

std::string_view name(TrialKind kind) noexcept {
  switch (kind) {
    case TrialKind::kPractice:
      return "practice";
    case TrialKind::kCatch:
      return "catch";
    case TrialKind::kScored:
      break;
  }
  return "scored";
}

std::optional<TrialKind> trial_kind_named(std::string_view text) noexcept {
  for (const TrialKind kind : {TrialKind::kPractice, TrialKind::kScored, TrialKind::kCatch})
    if (name(kind) == text) return kind;
  return std::nullopt;
}

std::string_view name(Answer answer) noexcept {
  switch (answer) {
    case Answer::kYes:
      return "yes";
    case Answer::kFirst:
      return "1";
    case Answer::kSecond:
      return "2";
    case Answer::kNo:
      break;
  }
  return "no";
}

std::optional<Answer> answer_named(std::string_view text) noexcept {
  for (const Answer answer : {Answer::kNo, Answer::kYes, Answer::kFirst, Answer::kSecond})
    if (name(answer) == text) return answer;
  return std::nullopt;
}

bool fits(Answer answer, Task task) noexcept {
  return (task == Task::kYesNo) == (answer == Answer::kNo || answer == Answer::kYes);
}

RunState::RunState(const Experiment& experiment, const RunSeeds& seeds, bool practice)
    : experiment_(experiment),
      seeds_(seeds),
      staircase_(experiment.rule),
      practice_left_(practice ? experiment.practice : 0) {}

bool RunState::catch_is_due() const noexcept {
  const int number = staircase_.state().scored + 1;
  if (experiment_.catch_one_in == 0 || catch_done_ || number == 1) return false;
  // At most one before each scored trial, so that two never follow each other; one in N of all
  // presentations means one for N - 1 scored ones.
  const double rate = 1.0 / (experiment_.catch_one_in - 1);
  return draw(seeds_.catches, Purpose::kCatchSchedule,
              {word_of(experiment_.name), static_cast<std::uint64_t>(number)}) < rate;
}

int RunState::interval_of_test(TrialKind kind, int number) const noexcept {
  if (experiment_.task == Task::kYesNo) return 0;
  const bool balanced = experiment_.order == IntervalOrder::kBalanced;
  const auto drawn = static_cast<std::uint64_t>(balanced ? (number + 1) / 2 : number);
  const bool second = draw(seeds_.order, Purpose::kIntervalOrder,
                           {word_of(experiment_.name), static_cast<std::uint64_t>(kind), drawn,
                            static_cast<std::uint64_t>(attempt_)}) < 0.5;
  return second != (balanced && number % 2 == 0) ? 2 : 1;
}

std::optional<Trial> RunState::next() const {
  if (staircase_.over()) return std::nullopt;
  Trial trial;
  trial.attempt = attempt_;
  trial.level = staircase_.level();
  trial.number = staircase_.state().scored + 1;
  if (practice_left_ > 0) {
    trial.kind = TrialKind::kPractice;
    trial.number = experiment_.practice - practice_left_ + 1;
  } else if (catch_is_due()) {
    trial.kind = TrialKind::kCatch;
    trial.level = 0;
    return trial;
  }
  trial.interval_of_test = interval_of_test(trial.kind, trial.number);
  return trial;
}

TrialOutcome RunState::answer(Answer answer) {
  const std::optional<Trial> trial = next();
  assert(trial && fits(answer, experiment_.task));
  TrialOutcome judged;
  judged.trial = *trial;
  judged.positive = answer == Answer::kYes ||
                    (answer == Answer::kFirst && trial->interval_of_test == 1) ||
                    (answer == Answer::kSecond && trial->interval_of_test == 2);
  attempt_ = 1;
  switch (trial->kind) {
    case TrialKind::kPractice:
      --practice_left_;
      break;
    case TrialKind::kCatch:
      catch_done_ = true;
      ++catches_;
      false_alarms_ += judged.positive ? 1 : 0;
      break;
    case TrialKind::kScored:
      catch_done_ = false;
      judgements_.push_back({to_value(trial->level, experiment_.decimals()), judged.positive});
      if (trial->interval_of_test != 0) {
        ++shown_[trial->interval_of_test - 1];
        right_[trial->interval_of_test - 1] += judged.positive ? 1 : 0;
      }
      judged.step = staircase_.answer(judged.positive);
      early_floor_ |= staircase_.state().floor_hits > 0 && staircase_.state().reversals.empty();
      break;
  }
  return judged;
}

void RunState::make_void() {
  assert(next());
  ++attempt_;
  ++voids_;
}

}  // namespace hedgehog::study

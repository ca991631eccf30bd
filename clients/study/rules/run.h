// SPDX-License-Identifier: MIT
// One participant's run through one experiment: the next trial, and the effect of a response or a
// void. Pure: the same events result in the same state, so a journal can be replayed.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "clients/study/rules/draw.h"
#include "clients/study/rules/fit/weibull_fit.h"
#include "clients/study/rules/staircase.h"

namespace hedgehog::study {

enum class TrialKind : std::uint8_t { kPractice, kScored, kCatch };

/// "practice", "scored", "catch".
std::string_view name(TrialKind kind) noexcept;
std::optional<TrialKind> trial_kind_named(std::string_view text) noexcept;

struct Trial {
  TrialKind kind = TrialKind::kScored;
  /// From 1; within the practice, or of the next scored trial (a catch trial comes before it).
  int number = 1;
  /// From 1; incremented by each void.
  int attempt = 1;
  /// 0 for a catch trial.
  Level level = 0;
  /// 1 or 2; 0: only one presentation.
  int interval_of_test = 0;
  friend bool operator==(const Trial&, const Trial&) = default;
};

/// The participant's response: yes/no, or the number of the interval.
enum class Answer : std::uint8_t { kNo = 0, kYes = 1, kFirst = 11, kSecond = 12 };

/// "no", "yes", "1", "2".
std::string_view name(Answer answer) noexcept;
std::optional<Answer> answer_named(std::string_view text) noexcept;
bool fits(Answer answer, Task task) noexcept;

struct TrialOutcome {
  Trial trial{};
  bool positive = false;
  /// Scored trials only.
  std::optional<Step> step{};
};

/// One stream per purpose; exported with the data.
struct RunSeeds {
  std::uint64_t order = 0;
  std::uint64_t catches = 0;
  friend bool operator==(const RunSeeds&, const RunSeeds&) = default;
};

class RunState {
 public:
  /// `practice` false omits the practice block.
  RunState(const Experiment& experiment, const RunSeeds& seeds, bool practice = true);

  /// nullopt once the run is over.
  std::optional<Trial> next() const;
  /// The response to the trial returned by `next`. REQUIRES: there is one, and `fits(answer,
  /// task)`.
  TrialOutcome answer(Answer answer);
  /// Repeats that trial, at the same level with a new interval order.
  void make_void();

  const Staircase& staircase() const noexcept { return staircase_; }
  /// Every scored response with its level.
  const std::vector<Judgement>& judgements() const noexcept { return judgements_; }
  int catches() const noexcept { return catches_; }
  int false_alarms() const noexcept { return false_alarms_; }
  int voids() const noexcept { return voids_; }
  /// The floor was hit before any reversal.
  bool early_floor() const noexcept { return early_floor_; }
  /// Number of scored trials with the test in interval 1 and 2, and of correct ones among them.
  const std::array<int, 2>& shown() const noexcept { return shown_; }
  const std::array<int, 2>& right() const noexcept { return right_; }

 private:
  bool catch_is_due() const noexcept;
  int interval_of_test(TrialKind kind, int number) const noexcept;

  Experiment experiment_;
  RunSeeds seeds_;
  Staircase staircase_;
  std::vector<Judgement> judgements_{};
  int practice_left_ = 0;
  int attempt_ = 1;
  bool catch_done_ = false;
  int catches_ = 0;
  int false_alarms_ = 0;
  int voids_ = 0;
  bool early_floor_ = false;
  std::array<int, 2> shown_{};
  std::array<int, 2> right_{};
};

}  // namespace hedgehog::study

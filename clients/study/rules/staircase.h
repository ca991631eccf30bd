// SPDX-License-Identifier: MIT
// The adaptive staircase: the level decreases after consecutive positives and increases after
// negatives, in steps that shrink with its reversals (thesis, section 3.2.1; Garcia-Perez 1998).
//
// Two-down/one-up with steps down of 0.5488 x steps up converges where p^2 * 0.5488 = 1 - p^2, at
// 80.35 % positive.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "clients/study/rules/experiment.h"

namespace hedgehog::study {

enum class Status : std::uint8_t { kIncomplete, kFinished, kAbortedMaxTrials };

/// "incomplete", "finished", "aborted_max_trials".
std::string_view name(Status status) noexcept;

/// Effect of one scored response.
struct Step {
  Level level = 0;            // of the response
  int move = 0;               // -1 down, 0 none, +1 up
  int reversal = 0;           // its ordinal from 1, or 0
  int run = 0;                // the run counter afterwards
  Level step_up = 0;          // in force for the next move
  std::optional<Level> next;  // nullopt once the run is over
  friend bool operator==(const Step&, const Step&) = default;
};

/// The complete state of a run in five fields, and two counts. Restoring it restores everything.
struct StaircaseState {
  Level level = 0;
  int direction = 0;
  /// Consecutive positives at this level; negatives count below 0.
  int run = 0;
  int scored = 0;
  std::vector<Level> reversals{};
  /// How often the next level, before clamping, was beyond the limits.
  int floor_hits = 0;
  int ceiling_hits = 0;
  friend bool operator==(const StaircaseState&, const StaircaseState&) = default;
};

/// A value: copies are independent.
class Staircase {
 public:
  /// REQUIRES: at least one stage, each with at least one reversal; floor <= start <= ceiling.
  explicit Staircase(const StaircaseRule& rule);
  /// Continues from `state`.
  Staircase(const StaircaseRule& rule, StaircaseState state);

  /// One scored response at `level()`. REQUIRES: !over().
  Step answer(bool positive);

  /// The next level to be presented; after the end the last level presented.
  Level level() const noexcept { return state_.level; }
  Status status() const noexcept;
  bool over() const noexcept { return status() != Status::kIncomplete; }
  /// The step up in force.
  Level step_up() const noexcept;
  /// The counted reversals: all but the first `discard`. Empty unless finished.
  std::vector<Level> counted_reversals() const;
  const StaircaseState& state() const noexcept { return state_; }

 private:
  const Stage& stage() const noexcept;
  int reversal_count() const noexcept { return static_cast<int>(state_.reversals.size()); }
  int move_after(bool positive) noexcept;
  Level moved(int move) noexcept;

  StaircaseRule rule_;
  StaircaseState state_;
};

}  // namespace hedgehog::study

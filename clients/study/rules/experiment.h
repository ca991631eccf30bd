// SPDX-License-Identifier: MIT
// Parameters of an experiment: the stimuli, and how the level follows the responses (thesis,
// section 3.2). The thesis' three are the files in config/study.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clients/study/rules/level.h"

namespace hedgehog::study {

/// Yes/no: one presentation, "did you feel it?". Two intervals: "which was stronger, quicker?".
enum class Task : std::uint8_t { kYesNo, kTwoIntervals };

/// Quantity of the level: a current in A, or the difference of the test interval from the
/// reference, in percentage points of the reference current or of the reference speed.
enum class Quantity : std::uint8_t { kCurrentA, kCurrentPercent, kSpeedPercent };

/// Independent fair coins, or the second of each pair of trials the opposite of the first. A
/// repeated trial is drawn again in either, so that a void unbalances its pair.
enum class IntervalOrder : std::uint8_t { kRandom, kBalanced };

/// Step sizes until `reversals` have been counted since the previous stage.
struct Stage {
  Level step_up = 0;
  Level step_down = 0;
  int reversals = 0;
  friend bool operator==(const Stage&, const Stage&) = default;
};

/// The transformed up/down rule (Levitt 1971) with steps of different size (Garcia-Perez 1998).
struct StaircaseRule {
  Level start = 0;
  Level floor = 0;
  Level ceiling = 0;
  std::vector<Stage> stages{};
  /// Consecutive positives for a step down, consecutive negatives for a step up.
  int positives_down = 2;
  int negatives_up = 1;
  /// One response is enough for a step until the first reversal.
  bool quick_start = true;
  /// Number of first reversals excluded from the mean.
  int discard = 2;
  /// Scored trials after which an unfinished run is aborted.
  int max_trials = 200;

  /// Reversals that end the run.
  int total_reversals() const noexcept;
  friend bool operator==(const StaircaseRule&, const StaircaseRule&) = default;
};

/// The moving push, and the parameters common to all trials.
struct Pattern {
  std::int64_t duration_ms = 5000;
  /// Pause between two intervals.
  std::int64_t gap_ms = 1000;
  double current_a = 5.0;      // of the reference
  double speed_pins_s = 10.0;  // of the reference; steps of the circle a second
  double ring_deg = 90.0;      // angle of the circle from the top
  bool clockwise = false;
  friend bool operator==(const Pattern&, const Pattern&) = default;
};

struct Experiment {
  std::string name{};  // "force-threshold"
  Task task = Task::kYesNo;
  Quantity quantity = Quantity::kCurrentA;
  /// The question for the participant.
  std::string question{};
  StaircaseRule rule{};
  Pattern pattern{};
  IntervalOrder order = IntervalOrder::kRandom;
  /// One in this many presentations is a catch trial, device off; 0: none. Yes/no only.
  int catch_one_in = 0;
  /// Trials at the start level before the run, never scored.
  int practice = 3;
  /// Later responses are void, by the wall clock; 0: no limit.
  std::int64_t response_limit_ms = 0;
  /// Number of scored trials between pauses; 0: no pauses.
  int rest_every = 0;

  int decimals() const noexcept;
  /// "A" or "%".
  const char* unit() const noexcept;
  friend bool operator==(const Experiment&, const Experiment&) = default;
};

/// Stimulus of one interval. 0 A: the device stays off.
struct Stimulus {
  double current_a = 0.0;
  double speed_pins_s = 0.0;
  friend bool operator==(const Stimulus&, const Stimulus&) = default;
};

Stimulus reference_stimulus(const Experiment& experiment) noexcept;
Stimulus test_stimulus(const Experiment& experiment, Level level) noexcept;

}  // namespace hedgehog::study

// SPDX-License-Identifier: MIT
#include "clients/study/report/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/wall_time.h"

namespace hedgehog::study {

namespace {

constexpr const char* kNone = "n/a";

std::string seconds(std::int64_t ns) { return exact_decimal(ns, 9); }

std::string number(double value) { return fmt::format("{:.6g}", value); }

template <class T, class Text>
std::string or_none(const std::optional<T>& value, Text text) {
  return value ? text(*value) : kNone;
}

/// The level as delivered: the nominal one, times the fraction that the limiter delivered.
std::string presented(const Experiment& e, const IntervalPlayed& test) {
  if (!test.delivered_mean && e.quantity != Quantity::kSpeedPercent) return kNone;
  const double current = test.stimulus.current_a * test.delivered_mean.value_or(0.0);
  switch (e.quantity) {
    case Quantity::kCurrentPercent:
      return number(100.0 * (current / e.pattern.current_a - 1.0));
    case Quantity::kSpeedPercent:
      return number(100.0 * (test.stimulus.speed_pins_s / e.pattern.speed_pins_s - 1.0));
    case Quantity::kCurrentA:
      break;
  }
  return number(current);
}

/// The interval of the test stimulus; the only one of a yes/no trial.
const IntervalPlayed* test_of(const TrialRecord& trial) {
  const int wanted = std::max(1, trial.trial.interval_of_test);
  const auto found = std::find_if(trial.intervals.begin(), trial.intervals.end(),
                                  [&](const IntervalPlayed& i) { return i.interval == wanted; });
  return found == trial.intervals.end() ? nullptr : &*found;
}

/// Device time relative to the first onset of the run. The device's clock restarts with the daemon;
/// the interruption is then measured by the journal's wall clock.
class RunClock {
 public:
  /// Called for each block, in order. nullopt if there was no onset or it cannot be determined.
  std::optional<std::int64_t> onset_of(const TrialRecord& record) {
    absent_ = absent_ || record.after_absence;
    if (record.intervals.empty()) return std::nullopt;
    const IntervalPlayed& first = record.intervals.front();
    const IntervalPlayed& last = record.intervals.back();
    const bool absent = std::exchange(absent_, false);
    if (zero_ && before_ && (absent || first.command_ns < before_->command_ns)) {
      const auto ended_ms = base::parse_rfc3339(before_->played);
      const auto begun_ms = base::parse_rfc3339(record.time);
      lost_ = lost_ || !ended_ms || !begun_ms;
      *zero_ += first.command_ns - before_->end_ns;
      *zero_ -= lost_ ? 0 : 1'000'000 * std::max<std::int64_t>(0, *begun_ms - *ended_ms);
    }
    before_ = {first.command_ns, last.offset_ns.value_or(last.ack_ns), record.played};
    zero_ = zero_ ? zero_ : first.onset_ns;
    return lost_ || !first.onset_ns ? std::nullopt : std::optional(*first.onset_ns - *zero_);
  }

 private:
  struct Block {
    std::int64_t command_ns = 0;
    std::int64_t end_ns = 0;
    std::string played{};
  };
  std::optional<Block> before_{};
  std::optional<std::int64_t> zero_{};
  bool absent_ = false;
  bool lost_ = false;
};

const char* move_name(int move) { return move < 0 ? "down" : move > 0 ? "up" : "none"; }

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> kColumns{
      {"participant", "code of the participant"},
      {"session", "1: all runs of a participant"},
      {"experiment", "name of the experiment"},
      {"run", "of this participant and experiment, from 1"},
      {"event", "presentation block of this run, from 1"},
      {"scored_trial", "ordinal among the scored trials; n/a for other kinds"},
      {"kind", "scored, catch, practice, or void (repeated)"},
      {"included", "1: it moved the staircase of a run that was not excluded"},
      {"excluded", "why the whole run was left out of the means; n/a: it was not"},
      {"time", "wall clock when the block began, UTC (RFC 3339)"},
      {"onset",
       "s, first onset after the first onset of the run, by the device's clock; where that began "
       "anew, by the journal's wall clock"},
      {"onset_2", "s, onset of the second interval, counted as onset; n/a for one presentation"},
      {"duration", "s, from the first onset to the last offset"},
      {"level_nominal", "level asked: A, or percentage points above the reference"},
      {"level_presented", "level as delivered by the limiter"},
      {"current_commanded_A", "current of the test interval"},
      {"current_measured_A", "highest current seen in the coils while it played"},
      {"speed_pps", "speed of the test interval, pins per second"},
      {"temperature_C", "hottest winding as estimated, after the last interval"},
      {"interval_of_test", "1 or 2; n/a for one presentation"},
      {"response", "yes, no, 1, 2"},
      {"correct", "1, 0; n/a where nothing is right or wrong"},
      {"response_time", "s, from the question"},
      {"move", "down, none, up"},
      {"reversal", "ordinal of the reversal made by this answer, or 0"},
      {"n_reversals", "reversals so far"},
      {"step_up", "step up in force afterwards, in units of the level"},
      {"run_count", "positives in a row afterwards"},
      {"at_floor", "1: presented at the floor"},
      {"at_ceiling", "1: presented at the ceiling"},
      {"t_command",
       "s, device time when the first interval was commanded; it begins anew with the daemon"},
      {"t_ack", "s, device time when the daemon had answered"},
      {"t_onset", "s, device time of the first onset"},
      {"t_offset", "s, device time of the last offset"},
      {"t_offset_1", "s, device time of the first interval's offset"},
      {"t_onset_2", "s, device time of the second interval's onset; n/a for one presentation"},
      {"orientation_w",
       "ball's orientation when the test interval ended, a quaternion from the ball to the world"},
      {"orientation_x", "its x"},
      {"orientation_y", "its y"},
      {"orientation_z", "its z"},
      {"seed_order", "seed of the interval orders of this run"},
      {"software_version", "hedgehog-study that recorded it"},
      {"in_mean",
       "1: the run is in the mean of its experiment; 0: it is excluded, not finished, followed by "
       "another run, or simulated where people took the experiment with a real ball"}};
  return kColumns;
}

std::vector<std::vector<std::string>> rows_of(const RecordedRun& run, const RunUse& use) {
  const RunStarted& header = run.header();
  const Experiment& e = header.experiment;
  std::vector<std::vector<std::string>> rows;
  RunClock clock;
  for (const TrialRecord& record : run.trials()) {
    const Trial& trial = record.trial;
    const bool counts = record.step.has_value();
    const bool is_void = !record.void_reason.empty();
    const IntervalPlayed* test = test_of(record);
    std::optional<std::int64_t> onset;
    std::optional<std::int64_t> offset;
    std::optional<std::int64_t> first_offset;
    std::optional<std::int64_t> second_onset;
    const std::optional<std::int64_t> since_first = clock.onset_of(record);
    if (!record.intervals.empty()) {
      onset = record.intervals.front().onset_ns;
      offset = record.intervals.back().offset_ns;
      first_offset = record.intervals.front().offset_ns;
    }
    if (record.intervals.size() > 1) second_onset = record.intervals[1].onset_ns;
    const auto axis = [&](double model::Quaternion::*component) {
      return test != nullptr && test->orientation ? number((*test->orientation).*component) : kNone;
    };
    const auto level = [&](Level value) { return exact_decimal(value, e.decimals()); };
    const auto flag = [](bool on) { return std::string(on ? "1" : "0"); };
    const bool judged = record.answered && e.task == Task::kTwoIntervals;
    rows.push_back(
        {header.participant,
         "1",
         e.name,
         std::to_string(header.run),
         std::to_string(rows.size() + 1),
         trial.kind == TrialKind::kScored && !is_void ? std::to_string(trial.number) : kNone,
         is_void ? "void" : std::string(name(trial.kind)),
         flag(counts && !use.excluded),
         use.excluded.value_or(kNone),
         record.time,
         or_none(since_first, seconds),
         since_first && onset && second_onset ? seconds(*since_first + *second_onset - *onset)
                                              : kNone,
         onset && offset ? seconds(*offset - *onset) : kNone,
         level(trial.level),
         test != nullptr ? presented(e, *test) : kNone,
         test != nullptr ? number(test->stimulus.current_a) : kNone,
         test != nullptr ? or_none(test->measured_a, number) : kNone,
         test != nullptr ? number(test->stimulus.speed_pins_s) : kNone,
         record.intervals.empty() ? kNone : or_none(record.intervals.back().temperature_c, number),
         trial.interval_of_test > 0 ? std::to_string(trial.interval_of_test) : kNone,
         record.answered ? std::string(name(record.answered->answer)) : kNone,
         judged ? flag(record.positive) : kNone,
         record.answered ? exact_decimal(record.answered->response_ms, 3) : kNone,
         counts ? move_name(record.step->move) : kNone,
         counts ? std::to_string(record.step->reversal) : kNone,
         counts ? std::to_string(record.reversals_after) : kNone,
         counts ? level(record.step_up_after) : kNone,
         counts ? std::to_string(record.run_after) : kNone,
         flag(trial.kind == TrialKind::kScored && trial.level == e.rule.floor),
         flag(trial.kind == TrialKind::kScored && trial.level == e.rule.ceiling),
         record.intervals.empty() ? kNone : seconds(record.intervals.front().command_ns),
         record.intervals.empty() ? kNone : seconds(record.intervals.front().ack_ns),
         or_none(onset, seconds),
         or_none(offset, seconds),
         or_none(first_offset, seconds),
         or_none(second_onset, seconds),
         axis(&model::Quaternion::w),
         axis(&model::Quaternion::x),
         axis(&model::Quaternion::y),
         axis(&model::Quaternion::z),
         std::to_string(header.seeds.order),
         header.software_version,
         flag(use.in_mean)});
  }
  return rows;
}

std::string tsv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    line += &cell == &cells.front() ? "" : "\t";
    for (const char c : cell) line += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
  }
  return line;
}

}  // namespace hedgehog::study

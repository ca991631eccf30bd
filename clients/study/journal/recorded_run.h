// SPDX-License-Identifier: MIT
// A run as recorded in its journal. Pure: the state is determined by the lines alone, so a killed
// run can resume from them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/journal/identity.h"

namespace hedgehog::study {

/// One presentation block: a trial with its stimuli and response.
struct TrialRecord {
  Trial trial{};
  std::string time{};    // start of the trial, RFC 3339, UTC
  std::string played{};  // when its last interval was recorded
  /// The program or the daemon was not running before it: the device's clock may have restarted.
  bool after_absence = false;
  std::vector<IntervalPlayed> intervals{};
  std::optional<Answered> answered{};
  /// Why it is excluded; empty: it is included.
  std::string void_reason{};
  bool positive = false;
  std::optional<Step> step{};
  int reversals_after = 0;
  Level step_up_after = 0;
  int run_after = 0;
};

class RecordedRun {
 public:
  /// The first line must be RunStarted.
  static Result<RecordedRun> replay(const std::vector<Line>& lines);

  /// Applies the next line. EX_DATAERR if it is inconsistent with those before.
  Result<void> take(const Line& line);

  const RunStarted& header() const noexcept { return header_; }
  /// The ball, and its most recent daemon.
  const Pin& pin() const noexcept { return pin_; }
  const std::optional<Checklist>& checklist() const noexcept { return checklist_; }
  const RunState& state() const noexcept { return state_; }
  /// Closed trials, in order.
  const std::vector<TrialRecord>& trials() const noexcept { return trials_; }
  /// The trial that was started and neither answered nor voided.
  const std::optional<TrialRecord>& open() const noexcept { return open_; }
  const std::vector<Line>& remarks() const noexcept { return remarks_; }
  std::int64_t lines() const noexcept { return lines_; }
  const std::string& started() const noexcept { return started_; }
  /// No result of the run may be shown on the experimenter's screen.
  bool blind() const noexcept;
  bool over() const noexcept { return state_.staircase().over(); }

 private:
  RecordedRun(const RunStarted& header, std::string started);
  Result<void> apply(const Line& line);
  Result<void> close(const Answered& event);

  RunStarted header_;
  Pin pin_;
  std::string started_;
  RunState state_;
  std::optional<Checklist> checklist_{};
  std::vector<TrialRecord> trials_{};
  std::optional<TrialRecord> open_{};
  std::vector<Line> remarks_{};
  std::int64_t lines_ = 1;
  bool absent_ = false;
};

}  // namespace hedgehog::study

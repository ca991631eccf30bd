// SPDX-License-Identifier: MIT
#include "clients/study/journal/recorded_run.h"

#include <algorithm>
#include <utility>

namespace hedgehog::study {

namespace {

Problem wrong(const Line& line, const std::string& what) {
  return {EX_DATAERR, "event " + std::to_string(line.number) + ": " + what};
}

}  // namespace

RecordedRun::RecordedRun(const RunStarted& header, std::string started)
    : header_(header),
      pin_{header.ball, header.daemon},
      started_(std::move(started)),
      state_(header.experiment, header.seeds) {}

Result<RecordedRun> RecordedRun::replay(const std::vector<Line>& lines) {
  if (lines.empty() || !std::holds_alternative<RunStarted>(lines.front().event))
    return Problem{EX_DATAERR, "does not begin with run_started"};
  RecordedRun run(std::get<RunStarted>(lines.front().event), lines.front().time);
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (auto taken = run.take(lines[i]); !taken) return taken.error();
  return run;
}

bool RecordedRun::blind() const noexcept {
  return header_.blind ||
         std::any_of(
             remarks_.begin(), remarks_.end(),
             [](const Line& line) { return std::get<Remark>(line.event).kind == "blind"; });
}

Result<void> RecordedRun::take(const Line& line) {
  if (line.number != lines_ + 1)
    return wrong(line, "comes after " + std::to_string(lines_) + ": lines are missing");
  if (auto applied = apply(line); !applied) return applied;
  ++lines_;
  return {};
}

Result<void> RecordedRun::apply(const Line& line) {
  if (std::holds_alternative<RunStarted>(line.event))
    return wrong(line, "a second run begins in the middle of one");
  if (const auto* checklist = std::get_if<Checklist>(&line.event)) {
    checklist_ = *checklist;
    return {};
  }
  if (const auto* changed = std::get_if<DaemonChanged>(&line.event)) {
    pin_.daemon = changed->daemon;
    absent_ = true;
    return {};
  }
  if (const auto* begun = std::get_if<TrialStarted>(&line.event)) {
    if (open_ || state_.next() != begun->trial)
      return wrong(line, "this is not the trial that was due");
    open_ = TrialRecord{
        .trial = begun->trial, .time = line.time, .after_absence = std::exchange(absent_, false)};
    return {};
  }
  if (const auto* remark = std::get_if<Remark>(&line.event)) {
    absent_ = absent_ || remark->kind == "resumed" ||
              (remark->kind == "continued" && remark->text == kBallReturned);
    remarks_.push_back(line);
    return {};
  }
  if (!open_) return wrong(line, "belongs to a trial, and none is open");
  if (const auto* played = std::get_if<IntervalPlayed>(&line.event)) {
    open_->intervals.push_back(*played);
    open_->played = line.time;
    return {};
  }
  if (const auto* answered = std::get_if<Answered>(&line.event)) {
    if (!fits(answered->answer, header_.experiment.task))
      return wrong(line, "that is no answer to this question");
    return close(*answered);
  }
  open_->void_reason = std::get<Voided>(line.event).reason;
  state_.make_void();
  trials_.push_back(*std::exchange(open_, std::nullopt));
  return {};
}

Result<void> RecordedRun::close(const Answered& event) {
  const TrialOutcome judged = state_.answer(event.answer);
  const Staircase& staircase = state_.staircase();
  open_->answered = event;
  open_->positive = judged.positive;
  open_->step = judged.step;
  open_->reversals_after = static_cast<int>(staircase.state().reversals.size());
  open_->step_up_after = staircase.step_up();
  open_->run_after = staircase.state().run;
  trials_.push_back(*std::exchange(open_, std::nullopt));
  return {};
}

}  // namespace hedgehog::study

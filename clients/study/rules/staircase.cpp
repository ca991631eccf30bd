// SPDX-License-Identifier: MIT
#include "clients/study/rules/staircase.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace hedgehog::study {

std::string_view name(Status status) noexcept {
  switch (status) {
    case Status::kFinished:
      return "finished";
    case Status::kAbortedMaxTrials:
      return "aborted_max_trials";
    case Status::kIncomplete:
      break;
  }
  return "incomplete";
}

Staircase::Staircase(const StaircaseRule& rule) : rule_(rule) { state_.level = rule.start; }

Staircase::Staircase(const StaircaseRule& rule, StaircaseState state)
    : rule_(rule), state_(std::move(state)) {}

Status Staircase::status() const noexcept {
  if (reversal_count() >= rule_.total_reversals()) return Status::kFinished;
  return state_.scored >= rule_.max_trials ? Status::kAbortedMaxTrials : Status::kIncomplete;
}

const Stage& Staircase::stage() const noexcept {
  int cumulative = 0;
  for (const Stage& stage : rule_.stages) {
    cumulative += stage.reversals;
    if (reversal_count() < cumulative) return stage;
  }
  return rule_.stages.back();
}

Level Staircase::step_up() const noexcept { return stage().step_up; }

int Staircase::move_after(bool positive) noexcept {
  const bool quick = rule_.quick_start && state_.reversals.empty();
  if (positive) {
    state_.run = std::max(state_.run, 0) + 1;
    return state_.run >= (quick ? 1 : rule_.positives_down) ? -1 : 0;
  }
  state_.run = std::min(state_.run, 0) - 1;
  return -state_.run >= (quick ? 1 : rule_.negatives_up) ? +1 : 0;
}

Level Staircase::moved(int move) noexcept {
  const Level wanted = move > 0 ? state_.level + stage().step_up : state_.level - stage().step_down;
  state_.floor_hits += wanted < rule_.floor ? 1 : 0;
  state_.ceiling_hits += wanted > rule_.ceiling ? 1 : 0;
  return std::clamp(wanted, rule_.floor, rule_.ceiling);
}

Step Staircase::answer(bool positive) {
  assert(!over());
  Step step;
  step.level = state_.level;
  ++state_.scored;
  step.move = move_after(positive);
  if (step.move != 0) {
    if (state_.direction != 0 && step.move != state_.direction) {
      // The level of the response that reversed the direction, not the level after it.
      state_.reversals.push_back(state_.level);
      step.reversal = reversal_count();
    }
    state_.direction = step.move;
    state_.run = 0;
    if (status() != Status::kFinished) {
      // With the step size after this reversal.
      state_.level = moved(step.move);
    }
  }
  step.run = state_.run;
  step.step_up = step_up();
  if (!over()) step.next = state_.level;
  return step;
}

std::vector<Level> Staircase::counted_reversals() const {
  const auto discard = static_cast<std::size_t>(rule_.discard);
  if (status() != Status::kFinished || state_.reversals.size() <= discard) return {};
  return {state_.reversals.begin() + static_cast<std::ptrdiff_t>(discard), state_.reversals.end()};
}

}  // namespace hedgehog::study

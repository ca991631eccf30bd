// SPDX-License-Identifier: MIT
#include "clients/study/session/simulated_desk.h"

#include <cmath>
#include <thread>

namespace hedgehog::study {

namespace {

constexpr double kQuickestMs = 350.0;
constexpr double kUsualMs = 450.0;

}  // namespace

SimulatedDesk::SimulatedDesk(const Observer& observer, std::uint64_t seed,
                             std::function<void(const View&)> report)
    : observer_(observer), seed_(seed), report_(std::move(report)) {}

void SimulatedDesk::show(const View& view) {
  view_ = view;
  report_(view);
}

Input SimulatedDesk::wait(std::chrono::milliseconds timeout) {
  if (view_.phase != Phase::kQuestion || !view_.run->open()) {
    std::this_thread::sleep_for(timeout);
    return {};
  }
  const Experiment& experiment = view_.run->header().experiment;
  const Trial& trial = view_.run->open()->trial;
  const double level = to_value(trial.level, experiment.decimals());
  const std::uint64_t what = word_of(experiment.name) + static_cast<std::uint64_t>(trial.kind);
  const bool positive = simulated_answer(observer_, level, seed_, what, trial.number);
  Input input;
  input.kind = Input::Kind::kAnswer;
  if (experiment.task == Task::kYesNo)
    input.answer = positive ? Answer::kYes : Answer::kNo;
  else
    input.answer = (trial.interval_of_test == 1) == positive ? Answer::kFirst : Answer::kSecond;
  const double slow = trial.attempt == 1 ? draw(seed_, Purpose::kReactionTime,
                                                {what, static_cast<std::uint64_t>(trial.number)})
                                         : draw(seed_, Purpose::kReactionTime,
                                                {what, static_cast<std::uint64_t>(trial.number),
                                                 static_cast<std::uint64_t>(trial.attempt)});
  input.response_ms = std::llround(kQuickestMs - kUsualMs * std::log1p(-slow));
  return input;
}

Observer simulated_person(const Experiment& experiment, std::uint64_t seed) {
  return drawn_observer(experiment, thesis_population(experiment.quantity), seed, seed);
}

}  // namespace hedgehog::study
